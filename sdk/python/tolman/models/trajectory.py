# SPDX-License-Identifier: BSD-3-Clause
"""A path instead of a camera: a file of an animal's positions, or a random walk in a box."""
import csv
import math
import pathlib

import numpy as np

import tolman

WALL_TURN = 5.0  # rad/s, at a wall


def _named(units):
    """Factors by the names of units, in singular and plural."""
    return {name: factor for names, factor in units for word in names.split() for name in (word, word + "s")}


_METRES = _named([("m meter metre", 1), ("dm decimeter decimetre", 0.1), ("cm centimeter centimetre", 0.01), ("mm millimeter millimetre", 0.001),
                  ("um \u00b5m \u03bcm micron micrometer micrometre", 1e-6), ("km kilometer kilometre", 1000), ("in inch inche", 0.0254)])
_SECONDS = _named([("s sec second", 1), ("ms msec millisecond", 1e-3), ("us \u00b5s \u03bcs usec microsecond", 1e-6), ("ns nsec nanosecond", 1e-9),
                   ("min minute", 60), ("h hour", 3600)])


class Trajectory(tolman.Source):
    """The motion along any path (CSV, NWB, or a random walk in a box), and views of its places, without images."""

    path: pathlib.Path = tolman.parameter("", doc="CSV with columns t (s), x, y (m; x forward, y left) and perhaps heading (rad), or NWB. "
                                          "Empty: a random walk in a box.")
    series: str = tolman.parameter("", doc="Series of positions in an NWB file, by its name; empty: the only one.")
    metres: float = tolman.parameter(0, range=(0, 1000), unit="m", doc="Length of one unit of the positions in an NWB file, e.g. pixels; 0: by its unit.")
    rate: float = tolman.parameter(10, range=(0.1, 1000), unit="Hz", doc="Frames a second; positions are interpolated.")
    duration: float = tolman.parameter(600, range=(1, 1e5), unit="s", doc="Of the random walk.")
    side: float = tolman.parameter(1.5, range=(0.1, 1e5), unit="m", doc="Of the box of the random walk.")
    rooms: int = tolman.parameter(1, range=(1, 8), doc="Such boxes, apart by their side, that the random walk visits one after the other, and then the first "
                                  "again. It is carried there, to a random place, and motion does not report it.")
    reported: bool = tolman.parameter(False, doc="Motion reports when the animal is carried: tracking restarts at an unknown pose. Otherwise it seems to stand still.")
    speed: float = tolman.parameter(0.2, range=(1e-3, 100), unit="m/s", doc="Mean speed of the random walk; it is Rayleigh distributed.")
    turning: float = tolman.parameter(2.0, range=(0, 5), unit="rad/s", doc="Standard deviation of the turning rate of the random walk.")
    view_every: int = tolman.parameter(10, range=(1, 100000), unit="frames", doc="Frames between two looks.")
    view_radius: float = tolman.parameter(0.1, range=(0, 1e6), unit="m", doc="A view is recognised within this; 0: there are no views.")
    view_angle: float = tolman.parameter(0.5, range=(0, 3.2), unit="rad", doc="And within this turn.")
    view_age: int = tolman.parameter(50, range=(1, 1000000), unit="frames", doc="Views younger than this are not reported.")

    def start(self):
        t, x, y, heading = self._walk() if self.path.name == "" else self._read()
        numbers = np.concatenate([t, x, y, [] if heading is None else heading])
        if len(t) < 2 or not np.all(np.isfinite(numbers)) or np.any(np.diff(t) <= 0):
            raise tolman.InvalidInput(f"{self.path}: needs two positions or more, numbers, in ascending time")
        self._tell_gaps(t)
        self.carried = [math.ceil(at * self.rate - 1e-6) for at in self._visits()] if self.path.name == "" else []  # frames
        self.time = np.arange(t[0], t[-1] + 1e-9, 1 / self.rate)
        x, y = np.interp(self.time, t, x), np.interp(self.time, t, y)
        if heading is None:  # of the motion; kept where the animal stands
            dx, dy = np.gradient(x), np.gradient(y)
            moves = np.hypot(dx, dy) > 1e-9
            known = np.maximum.accumulate(np.where(moves, np.arange(len(x)), 0))
            heading = np.arctan2(dy, dx)[known]
        else:
            heading = np.interp(self.time, t, np.unwrap(heading))
        self.poses = np.stack([x, y, heading], axis=1)
        self.sent, self.views = 0, []  # frames that made a view

    def _tell_gaps(self, t):
        steps = np.diff(t)
        gaps = np.flatnonzero(steps > max(1.0, 10 * np.median(steps)))
        if len(gaps) > 0:
            longest = gaps[np.argmax(steps[gaps])]
            self.log.warning(f"{self.path}: {len(gaps)} gaps without positions, the longest of {steps[longest]:.3g} s at "
                             f"t = {t[longest]:.6g} s; the path is a straight line there")

    def _visits(self):
        """Times of the walk when another room begins."""
        return [self.duration * visit / (self.rooms + 1) for visit in range(1, self.rooms + 1)] if self.rooms > 1 else []

    def _walk(self):
        """Ornstein-Uhlenbeck turning and speed; at a wall it slides and turns inward. The walk starts in the middle."""
        times, positions, headings = self._walk_in_box()
        visit = np.searchsorted(self._visits(), times + 1e-9, "right") % self.rooms
        return times, positions[:, 0] + 2 * self.side * visit, positions[:, 1], np.unwrap(headings)

    def _walk_in_box(self):
        step, count = 0.02, int(self.duration / 0.02) + 1
        at, angle, turning, vx = np.zeros(2), 0.0, 0.0, self.speed
        positions, headings, half = np.zeros((count, 2)), np.zeros(count), self.side / 2
        noise = self.rng.standard_normal((count, 2))
        goal = self.speed * np.sqrt(2 / math.pi) * np.hypot(*self.rng.standard_normal((2, count)))
        moves = [math.ceil(when / step - 1e-6) for when in self._visits()]
        for i in range(count):
            if i in moves:
                at, angle = self.rng.uniform(-half, half, 2), float(self.rng.uniform(0, 2 * math.pi))
            positions[i], headings[i] = at, angle
            turning += -turning * step / 0.1 + self.turning * math.sqrt(2 * step / 0.1) * noise[i, 0]
            vx += (goal[i] - vx) * step / 0.5
            angle += turning * step
            at = np.clip(at + vx * step * np.array([math.cos(angle), math.sin(angle)]), -half, half)
            if np.abs(at).max() == half:
                inward = math.atan2(-at[1], -at[0])
                turning = math.copysign(WALL_TURN, tolman.wrap_angle(inward - angle))
        return step * np.arange(count), positions, headings

    def _read(self):
        if not self.path.is_file():
            raise tolman.InvalidInput(f"{self.path}: there is no such file")
        return self._read_nwb() if self.path.suffix == ".nwb" else self._read_csv()

    def _read_csv(self):
        with open(self.path, "rb") as file:
            begin = file.read(4096)
        if begin.startswith((b"\xff\xfe", b"\xfe\xff")) or b"\0" in begin:
            raise tolman.InvalidInput(f"{self.path}: is no text in UTF-8 but has zero bytes, as UTF-16 has; save it as UTF-8")
        with open(self.path, newline="", encoding="utf-8-sig") as file:
            rows = list(csv.DictReader(file))
        try:
            columns = {name: np.array([float(row[name]) for row in rows]) for name in (rows[0] if rows else {})}
            return columns["t"], columns["x"], columns["y"], columns.get("heading")
        except (KeyError, ValueError, TypeError) as error:
            raise tolman.InvalidInput(f"{self.path}: needs columns t, x and y of numbers ({error})") from None

    def _read_nwb(self):
        try:
            import h5py
        except ImportError:
            raise tolman.Unsupported("NWB needs python3-h5py") from None
        with h5py.File(self.path) as file:
            series = self._series(file, h5py)
            stored = series["data"]
            of = stored.attrs
            unit = self.metres or self._factor(_METRES, of.get("unit", "meters"), "set metres, the length of one unit")
            data = (stored[:, :2] * of.get("conversion", 1.0) + of.get("offset", 0.0)) * unit
            times = series["timestamps" if "timestamps" in series else "starting_time"]
            second = self._factor(_SECONDS, times.attrs.get("unit", "seconds"), "write the times in seconds")
            t = second * (times[:] if times.ndim else times[()] + np.arange(len(data)) / times.attrs["rate"])
        known = np.isfinite(data).all(axis=1)  # trackers lose the animal
        return t[known], data[known, 0], data[known, 1], None

    def _series(self, file, h5py):
        """The series of positions: of a Position if there is one, with two columns or more; the only one, or the named one."""
        found = {}

        def visit(name, item):
            is_series = isinstance(item, h5py.Group) and item.attrs.get("neurodata_type") == "SpatialSeries"
            if is_series and item["data"].ndim == 2 and item["data"].shape[1] >= 2:
                found[name] = item

        file.visititems(visit)
        placed = {name: item for name, item in found.items() if item.parent.attrs.get("neurodata_type") == "Position"}
        found = {name: item for name, item in (placed or found).items() if not self.series or name.endswith("/" + self.series)}
        if len(found) == 1:
            return next(iter(found.values()))
        if not found:
            raise tolman.InvalidInput(f"{self.path}: has no SpatialSeries of positions" + (f" named {self.series}" if self.series else ""))
        raise tolman.InvalidInput(f"{self.path}: has several series of positions; set series to one of: {', '.join(found)}")

    def _factor(self, units, unit, remedy):
        name = unit.decode() if isinstance(unit, bytes) else str(unit)
        if name.lower() not in units:
            raise tolman.InvalidInput(f"{self.path}: has the unit '{name}', which is not known; {remedy}")
        return units[name.lower()]

    def info(self):
        return tolman.SourceInfo(f"path of {len(self.poses)} frames", frames=len(self.poses), has_truth=True)

    def next(self):
        if self.sent >= len(self.poses):
            return None
        k, self.sent = self.sent, self.sent + 1
        here, before = self.poses[k], self.poses[max(k - 1, 0)]
        moved = np.zeros(3) if k in self.carried else np.array(tolman.between(before, here))
        sensors = {"motion.planar": moved, "place.candidate": np.zeros((0, 4)),
                   "place.looked": np.zeros(1), "motion.drive": np.ones(1)}
        if self.reported:
            sensors["motion.unknown"] = np.full(1, float(k in self.carried))
        if self.view_radius > 0 and k % self.view_every == 0:
            sensors["place.looked"] = np.ones(1)
            seen = self._seen(k)
            if seen is None:
                self.views.append(k)
            else:
                sensors["place.candidate"] = np.array([[seen, *tolman.between(here, self.poses[seen])]])
        truth = tolman.from_planar(*tolman.between(self.poses[0], here))
        return tolman.Frame(k, round((self.time[k] - self.time[0]) * 1e9), k, None, None, True, truth, "", sensors)

    def _seen(self, k):
        """The frame that made the nearest view, None where none is near."""
        old = [i for i in self.views if k - i >= self.view_age]
        if not old:
            return None
        off = self.poses[old] - self.poses[k]
        away = np.hypot(off[:, 0], off[:, 1])
        away[np.abs((off[:, 2] + math.pi) % (2 * math.pi) - math.pi) > self.view_angle] = np.inf
        return old[int(np.argmin(away))] if away.min() <= self.view_radius else None
