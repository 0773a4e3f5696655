# SPDX-License-Identifier: BSD-3-Clause
"""A run as one file of NumPy arrays, which needs neither SQL nor this package to be read.

    tolman export RUN --npz          python3 -m tolman.npz RUN [FILE] [--force]

    file = numpy.load("run.npz")
    file["trajectory/map/x"], file["link/from_experience"], file["array/grid.activity/values"]
    units = json.loads(str(file["units"]))               # by the names of the arrays

`trajectory/...` are planar poses: x forward and y left in m, heading in rad. Every table of run.sqlite is there without its
binary columns, `from` and `to` of links under names that are no words of SQL. `array/NAME` are recorded arrays with the
values of their axes, `rate_map/NAME` and `tuning/NAME` what their units do over place and heading.
"""
import argparse
import json
import pathlib
import sys

import numpy as np

from tolman._files import add_output_options, exit_code_of, replacing, write_output, written
from tolman.results import Run, unit_by_scale, unit_of

_TABLES = ("frame", "motion", "place", "decision", "map_update", "experience", "link", "event", "timing", "session")
_RENAMED = {("link", "from"): "from_experience", ("link", "to"): "to_experience"}


class _Arrays:
    def __init__(self):
        self.arrays, self.units = {}, {}

    def add(self, name, values, unit=""):
        values = np.asarray(values)
        if values.dtype == object:
            values = np.array([str(value) for value in values], dtype=str) if len(values) else np.zeros(0, str)
        self.arrays[name] = values
        if unit:
            self.units[name] = unit


def _columns(table):
    return table.dtype.names if isinstance(table, np.ndarray) else list(table.columns)


def _add_tables(run, out):
    for name in _TABLES:
        table = run.table(name)
        for column in _columns(table):
            out.add(f"{name}/{_RENAMED.get((name, column), column)}", table[column], unit_of(column))
    for of in ("map", "truth"):
        table = run.trajectory(of)
        for column in _columns(table):
            out.add(f"trajectory/{of}/{column}", table[column], unit_of(column))


def _add_array(array, name, out):
    key = f"array/{name}"
    out.add(f"{key}/frame", array.frames)
    out.add(f"{key}/stamp_ns", array.stamps_ns, "ns")
    if array.values.dtype == object:  # rows of different lengths, one behind the other
        out.add(f"{key}/shapes", np.array([part.shape for part in array.values]))
        out.add(f"{key}/values", np.concatenate([part.ravel() for part in array.values]), array.unit)
        return
    out.add(f"{key}/values", array.values, array.unit)
    for axis, phases in zip(array.axes, array.phases):
        out.add(f"{key}/axis/{axis.name}", phases, axis.unit)


def _add_rates(run, name, out):
    maps, tuning = run.rate_maps(name), run.tuning(name)
    out.add(f"rate_map/{name}/values", maps.values, run.array(name).unit)
    out.add(f"rate_map/{name}/visits", maps.visits)
    out.add(f"rate_map/{name}/x_edges", maps.x_m, "m")
    out.add(f"rate_map/{name}/y_edges", maps.y_m, "m")
    out.add(f"tuning/{name}/values", tuning.values, run.array(name).unit)


def _arrays_of(run):
    out = _Arrays()
    _add_tables(run, out)
    for name in run.arrays:
        array = run.array(name)
        _add_array(array, name, out)
        if array.info.kind == "activity" and array.values.dtype != object:
            _add_rates(run, name, out)
    if not run.scale_known:  # lengths of odometry and map are in arbitrary units, those of the truth are not
        of_truth = ("frame/", "array/", "trajectory/truth/") + (("rate_map/",) if run.frames["has_truth"].max() else ())
        for name, unit in out.units.items():
            if not name.startswith(of_truth):
                out.units[name] = unit_by_scale(unit, False)
    return out


def write(run_directory, file=None):
    """Writes `file`, by default run.npz in the run directory; returns its path. Of a run that goes on: its state of one moment."""
    run = Run(run_directory)
    with run.one_state():
        out = _arrays_of(run)
    file = pathlib.Path(file) if file else run.path / "run.npz"
    with written(file), replacing(file) as temporary, open(temporary, "wb") as stream:
        np.savez_compressed(stream, units=json.dumps(out.units), **out.arrays)
    return file


def main():
    parser = argparse.ArgumentParser(prog="tolman.npz", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run")
    parser.add_argument("file", nargs="?")
    add_output_options(parser)
    arguments = parser.parse_args()
    return exit_code_of(lambda: write_output(arguments, arguments.file, lambda: write(arguments.run, arguments.file)))


if __name__ == "__main__":
    sys.exit(main())
