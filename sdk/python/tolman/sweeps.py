# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps and comparisons (docs/experiments.md) from Python.

    study = tolman.sweep("study.yaml", jobs=2)           # a Sweep; what is done already is not run again
    study.table("map.ate.rmse_m")                        # a row a run: its factors and metrics
    study.runs                                           # [({"model": "ssp", ...}, Run), ...]
    tolman.compare(study, by="model")                    # a row a level: mean, interval, difference, p
"""
import csv
import json
import pathlib
import tempfile
import warnings

from tolman.program import call
from tolman.results import Run, _table


class Sweep:
    """The folder of a sweep."""

    def __init__(self, path):
        self.path = pathlib.Path(path).resolve()
        if not (self.path / "points.txt").is_file():
            raise FileNotFoundError(f"{self.path}: is no folder of a sweep, for it has no points.txt")

    def __repr__(self):
        return f"tolman.Sweep({str(self.path)!r})"

    def __fspath__(self):
        return str(self.path)

    @property
    def runs(self):
        """(factors, Run) of each run of the last plan that is done and belongs to a level, in the order of their names."""
        found, left_out = [], 0
        for name in sorted((self.path / "points.txt").read_text(encoding="utf-8").splitlines()):
            factors, done = _point(self.path / name)
            if factors and done:
                found.append((factors, Run(self.path / name / "run")))
            elif not done:
                left_out += 1
        if left_out:
            warnings.warn(f"{self.path}: {left_out} runs failed or are not done, and are left out; see `tolman sweep status`",
                          stacklevel=2)
        return found

    def table(self, *metrics):
        """Factors and metrics of the runs that are done; all metrics where none is named."""
        with tempfile.TemporaryDirectory(prefix="tolman-") as folder:
            file = pathlib.Path(folder) / "table.csv"
            call("sweep", "collect", self, "--out", file, *(word for metric in metrics for word in ("--metric", metric)))
            return _read(file)


def _point(folder):
    """Factors of a planned run, and whether it is done; {} for a folder that is missing or damaged."""
    point = _object(folder / "point.json")
    factors = point.get("factors")
    if not isinstance(factors, list):
        return {}, False
    return {factor["name"]: factor["label"] for factor in factors}, _object(folder / "outcome.json").get("state") == "done"


def _object(file):
    """The object in a JSON file; {} where it is missing or damaged: that run is left out, and reported as left out."""
    try:
        contents = json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
    except ValueError:
        return {}
    return contents if isinstance(contents, dict) else {}


def sweep(config, out=None, jobs=None):
    """Makes the runs of a sweep that are not done yet. Gives the Sweep; raises RunFailed if some failed."""
    out = pathlib.Path("sweeps") / pathlib.Path(config).stem if out is None else out
    call("sweep", config, "--out", out, *(() if jobs is None else ("--jobs", jobs)))
    return Sweep(out)


def compare(*runs, by, metric="map.ate.rmse_m", only=None, baseline=None):
    """The table of `tolman compare`: `runs` are a Sweep, Runs, folders or tables; `by` is a factor or several; only={factor: label}."""
    options = ["--metric", metric]
    for factor in [by] if isinstance(by, str) else by:
        options += ["--by", factor]
    for factor, label in (only or {}).items():
        options += ["--only", f"{factor}={label}"]
    if baseline is not None:
        options += ["--baseline", baseline]
    with tempfile.TemporaryDirectory(prefix="tolman-") as folder:
        file = pathlib.Path(folder) / "table.csv"
        call("compare", *(run.path if isinstance(run, Run) else run for run in runs), *options, "--format", "csv", "--out", file)
        return _read(file)


def _read(file):
    """A table: columns are of integers or of numbers where each of their fields is one, or is empty."""
    with open(file, newline="") as stream:
        names, *rows = csv.reader(stream)
    columns = [_column(column) for column in zip(*rows)] if rows else [("TEXT", ())] * len(names)
    return _table(names, [kind for kind, _ in columns], zip(*(values for _, values in columns)))


def _column(texts):
    for kind, number in (("INTEGER", int), ("REAL", lambda text: float(text or "nan"))):
        try:
            values = [number(text) for text in texts]
        except ValueError:
            continue
        if any(texts) and [text for text in texts if len(text) > 1 and text[0] == "0" and text.isdigit()] == []:  # 07 is a name
            return kind, values
    return "TEXT", texts
