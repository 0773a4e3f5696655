# SPDX-License-Identifier: BSD-3-Clause
"""The results of a run: tables, arrays, and measures of cells, from run.sqlite. Also of a run that goes on or was killed.

    run = tolman.Run("runs/latest")
    run.motion, run.decisions, run.map, run.events      # pandas tables; NumPy structured arrays without pandas
    run.array("grid.activity").values                    # frames x rows x columns
    run.rate_maps("grid.activity"), run.tuning("hd.activity"), run.metrics
"""
import contextlib
import functools
import json
import pathlib
import re
import warnings

import numpy as np

from tolman import _record_check, cells, records, spatial

_TYPES = {"INTEGER": np.int64, "REAL": np.float64}

# Units of columns that follow from the name alone; see docs/reference/records.md.
_UNITS = {"stamp_ns": "ns", "duration_ns": "ns", "time_ns": "ns", "dt": "s", "duration": "s", "v": "m/s",
          "omega": "rad/s", "heading": "rad", "relative_yaw": "rad", "x": "m", "y": "m", "baseline": "m",
          "width": "px", "height": "px"}  # yapf: disable
_OF_SOURCE = ("frame", "camera")  # tables whose lengths are metres also where odometry knows no scale


def unit_of(column):
    """The unit of a column, "" for none."""
    if column.startswith("pinhole_"):
        return "px"
    if column.startswith("T_") and column.rpartition("_")[2] in ("x", "y", "z"):
        return "m"
    return _UNITS.get(column, "")


def unit_by_scale(unit, scale_known):
    """The unit of lengths of odometry and map: "units" for metres where the scale is unknown."""
    return unit if scale_known else {"m": "units", "m/s": "units/s"}.get(unit, unit)


def _table(names, types, rows, scale_known=True):
    """A pandas table with its units in `attrs`, or a structured array."""
    kinds = [_TYPES.get(kind, object) for kind in types]
    array = np.array([tuple(row) for row in rows], dtype=list(zip(names, kinds)))
    try:
        import pandas
    except ImportError:
        return array
    table = pandas.DataFrame({name: array[name] for name in names})
    table.attrs["units"] = {name: unit_by_scale(unit_of(name), scale_known) for name in names}
    return table


def rows_where(table, own):
    """Rows of a table, counted from 0."""
    part = table[own]
    return part.reset_index(drop=True) if hasattr(part, "reset_index") else part


class Run:
    """One run directory."""

    def __init__(self, path):
        self.path = pathlib.Path(path).resolve()
        file = self.path / "run.sqlite"
        if not file.is_file():
            raise FileNotFoundError(f"{self.path}: is no run directory, for it has no run.sqlite")
        info = self.info  # before the database: a run that ends in between has written its last rows
        self._database = _record_check.connect(file)
        with self.one_state():
            _record_check.require_whole(self._database, file, info)

    def __repr__(self):
        return f"tolman.Run({str(self.path)!r})"

    @contextlib.contextmanager
    def one_state(self):
        """All that is read of run.sqlite within this context is of one moment, also if the run goes on meanwhile."""
        self._database.execute("BEGIN")
        try:
            yield self
        finally:
            self._database.rollback()

    def _json(self, name):
        file = self.path / name
        contents = {}
        try:
            if file.is_file():
                contents = json.loads(file.read_text())
        except ValueError as error:
            raise ValueError(f"{file}: is damaged ({error}); put it back, or run it again") from error
        if not isinstance(contents, dict):
            raise ValueError(f"{file}: is damaged, it holds no names and values; put it back, or run it again")
        return contents

    @property
    def info(self):
        """What run.json says: versions, plugins with digests, machine, counters."""
        return self._json("run.json")

    @property
    def metrics(self):
        """What metrics.json says; empty while the run goes on, and after one that was killed or has failed."""
        file = self.path / "metrics.json"
        if not file.is_file() and self.info.get("status") in ("finished", "interrupted"):
            raise FileNotFoundError(f"{file}: is missing, although the run has ended; put it back, or run it again")
        return self._json("metrics.json")

    def table(self, name):
        """A table of run.sqlite without its binary columns."""
        columns = [(row[1], row[2]) for row in self._database.execute(f'PRAGMA table_info("{name}")') if row[2] != "BLOB"]
        if not columns:
            raise KeyError(f"{self.path}: run.sqlite has no table '{name}'")
        listed = ", ".join(f'"{column}"' for column, _ in columns)
        rows = self._database.execute(f'SELECT {listed} FROM "{name}" ORDER BY rowid')
        return _table(*zip(*columns), rows, name in _OF_SOURCE or self.scale_known)

    frames = property(lambda self: self.table("frame"), doc="What the source gave.")
    motion = property(lambda self: self.table("motion"), doc="Answers of odometry.")
    places = property(lambda self: self.table("place"), doc="Answers of place recognition.")
    decisions = property(lambda self: self.table("decision"), doc="Answers of the cells.")
    map = property(lambda self: self.table("map_update"), doc="Answers of the map.")
    experiences = property(lambda self: self.table("experience"), doc="Nodes of the map.")
    links = property(lambda self: self.table("link"), doc="Constraints of the map.")
    events = property(lambda self: self.table("event"), doc="What happened beside the answers.")
    timing = property(lambda self: self.table("timing"), doc="Wall time of the stages.")

    def covariances(self, name):
        """The 6x6 covariances of a table such as "motion", one for each of its rows."""
        rows = self._database.execute(f'SELECT covariance FROM "{name}" ORDER BY rowid').fetchall()
        return np.array([np.frombuffer(row[0]).reshape(6, 6) for row in rows]).reshape(-1, 6, 6)

    def trajectory(self, of="map"):
        """Planar poses: frame, stamp_ns, x (forward), y (left), heading, session. `of`: map (the finished one), truth, or best.

        `best` is the truth where the run has one, else the map. In a continued run (docs/sessions.md) the truth of each
        session has a world of its own, unless the data say otherwise, and parts of a map that no link joins have as well.
        """
        if of == "best":
            of = "truth" if self._has_truth() else "map"
        rows = self._database.execute(_POSES[of]).fetchall()
        if of == "map" and not rows:
            rows = self._database.execute(_POSES["known"]).fetchall()
        frame, stamp, x, z, qx, qy, qz, qw = (np.array(column) for column in zip(*rows)) if rows else [np.zeros(0)] * 8
        axis_x, axis_z = 2 * (qx * qz + qw * qy), 1 - 2 * (qx * qx + qy * qy)  # of the optical axis
        heading = np.arctan2(-axis_x, axis_z)
        first = [row[0] for row in self._database.execute("SELECT first_frame FROM session ORDER BY id")] or [0]
        session = np.maximum(np.searchsorted(first, frame, "right") - 1, 0)
        return _table(("frame", "stamp_ns", "x", "y", "heading", "session"),
                      ("INTEGER", "INTEGER", "REAL", "REAL", "REAL", "INTEGER"), zip(frame, stamp, z, -x, heading, session),
                      of == "truth" or self.scale_known)

    @property
    def scale_known(self):
        """Whether lengths of odometry and map are metres; False for a single camera."""
        return self._database.execute("SELECT count(*) FROM motion WHERE NOT scale_known").fetchone()[0] == 0

    @functools.cached_property
    def first_measured(self):
        """First frame that figures are of, as in metrics.json: of the run's own session, or with `evaluation.sessions: joint` 0."""
        config = self.path / "config.resolved.yaml"
        joint = config.is_file() and re.search(r"^ +sessions: joint$", config.read_text(), re.MULTILINE)
        row = self._database.execute("SELECT max(first_frame) FROM session").fetchone()
        return 0 if joint or row[0] is None else row[0]

    def measured_poses(self):
        """The poses `best` that figures are of. Warns where parts of the map have unknown poses to each other."""
        poses = self.trajectory("best")
        sessions = self.metrics.get("sessions") or [{}]
        if self.first_measured > 0:
            sessions = sessions[-1:]
        parts = {part for session in sessions for part in session.get("parts", ())}
        if len(parts) > 1 and not self._has_truth():
            warnings.warn(f"{self.path}: the map is in {len(parts)} parts that no link joins; positions of different parts "
                          "are not of one world, nor are measures of them together", stacklevel=3)
        return rows_where(poses, np.asarray(poses["frame"]) >= self.first_measured)

    def _has_truth(self):
        return bool(self._database.execute("SELECT max(has_truth) FROM frame WHERE frame >= ?",
                                           (self.first_measured,)).fetchone()[0])

    @functools.cached_property
    def descriptions(self):
        """ArrayInfo by name, of the arrays that have one."""
        rows = self._database.execute("SELECT name, kind, unit, doc, population, axes FROM array_info")
        return {row[0]: records.ArrayInfo(*row[:5], [records.ArrayAxis(**axis) for axis in json.loads(row[5])])
                for row in rows}

    @property
    def arrays(self):
        """Names of the recorded arrays."""
        return [row[0] for row in self._database.execute("SELECT DISTINCT name FROM array ORDER BY name")]

    def array(self, name):
        """A recorded array over all frames: cells.Array."""
        rows = self._database.execute('SELECT a.frame, f.stamp_ns, a.shape, a."values" FROM array a JOIN frame f '
                                      "ON f.frame = a.frame WHERE a.name = ? ORDER BY a.frame", (name,)).fetchall()
        if not rows:
            raise KeyError(f"{self.path}: no array '{name}'; there are {', '.join(self.arrays) or 'none'}")
        parts = [np.frombuffer(row[3], np.float32).reshape([int(size) for size in row[2].split("x")]) for row in rows]
        if len({part.shape for part in parts}) == 1:
            values = np.stack(parts)
        else:  # such as a list of hypotheses
            values = np.empty(len(parts), object)
            values[:] = parts
        info = self.descriptions.get(name, records.ArrayInfo(name))
        return cells.Array(info, np.array([row[0] for row in rows]), np.array([row[1] for row in rows]), values)

    def _walk(self, array):
        """Position, heading and rates at the frames that have both."""
        poses = self.measured_poses()
        own = {int(frame): i for i, frame in enumerate(poses["frame"])}
        rows = [(own[int(frame)], k) for k, frame in enumerate(array.frames) if int(frame) in own]
        at, of = (np.array(column, int) for column in zip(*rows)) if rows else (np.zeros(0, int), np.zeros(0, int))
        x, y, heading = (np.asarray(poses[name])[at] for name in ("x", "y", "heading"))
        return x, y, heading, array.values[of].reshape(len(of), -1)

    def rate_maps(self, name, bin_m=None):
        """Mean rate of every unit in square bins of the plane: cells.RateMaps. Bins: a 24th of the longer side."""
        array = self.array(name)
        x, y, _, rates = self._walk(array)
        return cells.rate_maps(x, y, rates, array.values.shape[1:], bin_m)

    def tuning(self, name, bins=36):
        """Mean rate of every unit by heading: cells.Tuning."""
        array = self.array(name)
        _, _, heading, rates = self._walk(array)
        return cells.tuning(heading, rates, array.values.shape[1:], bins)

    def scores(self, name, bin_m=None, shuffles=100, units=64, seed=1):
        """A table with a row for each measured unit: spatial.GridScores, information, fields, stability, and chance.

        `units` at the most are measured, evenly spaced. Chance is the 95th percentile of `shuffles` units whose rates are
        shifted in time by a tenth of the run or more, in columns that end with _chance.
        """
        array = self.array(name)
        x, y, _, rates = self._walk(array)
        if len(x) < 20:
            raise ValueError(f"{self.path}: fewer than 20 frames have a pose and '{name}'")
        chosen = np.unique(np.linspace(0, rates.shape[1] - 1, min(units, rates.shape[1])).astype(int))
        rng, rows = np.random.default_rng(seed), [_unit_scores(x, y, rates[:, i], bin_m) for i in chosen]
        least = max(1, len(x) // 10)
        shifted = [_unit_scores(x, y, np.roll(rates[:, rng.choice(chosen)], rng.integers(least, len(x) - least + 1)), bin_m)
                   for _ in range(shuffles)]
        names = list(rows[0])
        chance = [_percentile([row[key] for row in shifted], 95) for key in _WITH_CHANCE] if shifted else []
        columns = ["unit", *names, *(f"{key}_chance" for key in _WITH_CHANCE[:len(chance)])]
        return _table(columns, ["INTEGER"] + ["REAL"] * (len(columns) - 1),
                      [(int(i), *row.values(), *chance) for i, row in zip(chosen, rows)])


_WITH_CHANCE = ("sargolini", "langston", "square", "information_bits", "stability")


def _percentile(values, share):
    known = [value for value in values if np.isfinite(value)]
    return float(np.percentile(known, share)) if known else float("nan")


def _unit_scores(x, y, rates, bin_m):
    """Of one unit, as spatial.py measures it."""
    maps = cells.rate_maps(x, y, rates[:, None], (1,), bin_m)
    bin_m = maps.x_m[1] - maps.x_m[0]
    grid, sizes = spatial.grid_scores(maps.values[0]), spatial.fields(maps.values[0])
    halves = []
    for part in (slice(0, len(x) // 2), slice(len(x) // 2, None)):  # in the bins of the whole run
        row, column = (np.clip(np.searchsorted(edges, values[part], "right") - 1, 0, len(edges) - 2)
                       for edges, values in ((maps.x_m, x), (maps.y_m, y)))
        sums, visits = np.zeros(maps.visits.shape), np.zeros(maps.visits.shape)
        np.add.at(sums, (row, column), rates[part])
        np.add.at(visits, (row, column), 1)
        halves.append(np.where(visits > 0, sums / np.maximum(visits, 1), np.nan))
    return {"sargolini": grid.sargolini, "langston": grid.langston, "square": grid.square, "spacing_m": grid.spacing * bin_m,
            "information_bits": spatial.spatial_information(maps.values[0], maps.visits), "fields": float(len(sizes)),
            "field_m2": float(np.median(sizes)) * bin_m**2 if sizes else float("nan"), "stability": spatial.correlation(*halves)}


def _poses(table, prefix, where=""):
    columns = ", ".join(f't."{prefix}_{part}"' for part in ("x", "z", "qx", "qy", "qz", "qw"))
    return f"SELECT f.frame, f.stamp_ns, {columns} FROM {table} t JOIN frame f ON f.frame = t.frame {where} ORDER BY f.frame"


_POSES = {
    "map": _poses("final_pose", "T_world_camera"),
    "known": _poses("map_update", "T_world_camera"),
    "truth": _poses("frame", "T_world_camera_truth", "WHERE t.has_truth"),
}
