# SPDX-License-Identifier: BSD-3-Clause
"""A run as an NWB file (Neurodata Without Borders 2.6): position, head direction, rates, spikes, laps, views, origin.

    tolman export RUN --nwb          python3 -m tolman.nwb RUN [FILE] [--force]

Times are seconds since the first frame. Of a continued run the file has the last session, or with
`evaluation.sessions: joint` all. Rates of populations without the unit Hz are scaled so that the highest of the
population is `peak_hz`. Spikes are Poisson, seeded by the run's seed and the number of the unit, constant in rate
between two frames, in steps of 0.1 ms.
"""
import argparse
import io
import json
import pathlib
import sys

import numpy as np

from tolman import cells
from tolman._files import add_output_options, exit_code_of, replacing, write_output, written
from tolman.results import Run, rows_where

SPIKE_RESOLUTION_S = 1e-4
PEAK_HZ = 20.0
_LONGEST_STEP = 5  # median steps between frames; no spikes in what a longer gap has beyond
_LONGEST_STEP_S = 10.0  # the same for frames that are all far apart: no rate is known for hours


def spikes(rates_hz, seconds, seed):
    """Spike times of one unit, ascending: a Poisson process with the rate of each frame up to the next one."""
    if len(seconds) < 2:
        return np.zeros(0)
    rng = np.random.Generator(np.random.PCG64(seed))
    steps = np.diff(seconds, append=2 * seconds[-1] - seconds[-2])
    steps = np.minimum(steps, min(_LONGEST_STEP * np.median(steps), _LONGEST_STEP_S))
    counts = rng.poisson(np.maximum(rates_hz, 0) * steps)
    times = np.repeat(seconds, counts) + rng.random(counts.sum()) * np.repeat(steps, counts)
    return np.sort(np.round(times / SPIKE_RESOLUTION_S) * SPIKE_RESOLUTION_S)


def laps(x, y, seconds):
    """(start, stop) of each whole round: from the start to the next return to it, within a tenth of the largest distance."""
    distance = np.hypot(x - x[0], y - y[0])
    near = 0.1 * distance.max()
    bounds, away = [seconds[0]], False
    for moment, far in zip(seconds, distance):
        if far > 2 * near:
            away = True
        elif away and far <= near:
            bounds.append(moment)
            away = False
    return list(zip(bounds[:-1], bounds[1:]))


_HERTZ = {"hz": 1, "1/s": 1, "s^-1": 1, "spikes/s": 1, "khz": 1000}


def _populations(run):
    """The recorded arrays of rates, of the measured frames."""
    named = [name for name in run.arrays if name in run.descriptions and run.descriptions[name].kind == "activity"]
    arrays = []
    for name in named:
        array = run.array(name)
        own = array.frames >= run.first_measured
        arrays.append(cells.Array(array.info, array.frames[own], array.stamps_ns[own], array.values[own]))
    return arrays


def _rates(array, peak_hz):
    """In hertz; None for an activity below 0, which no firing rate has."""
    flat = array.values.reshape(len(array.values), -1).astype(np.float64)
    if flat.size and flat.min() < 0:
        return None
    factor = _HERTZ.get(array.unit.lower())
    if factor:
        return flat * factor
    highest = flat.max() if flat.size else 0
    return flat if highest <= 0 else flat * (peak_hz / highest)


def _unit_columns(array, module):
    """One row a unit: name of the population, kind, module, indices, phases and period."""
    shape, axes = array.values.shape[1:], array.axes
    index = np.indices(shape).reshape(len(shape), -1)
    angular = len(axes) == 1 and axes[0].unit in ("rad", "deg")
    kind = "head direction" if angular else "grid" if sum(axis.period > 0 for axis in axes) == 2 else "other"
    phases = [array.phases[k][index[k]] if k < len(axes) else np.full(index.shape[1], np.nan) for k in range(min(2, len(shape)))]
    while len(phases) < 2:
        phases.append(np.full(index.shape[1], np.nan))
    size = index.shape[1]
    return {"population": [array.info.name] * size, "kind": [kind] * size, "module": [module] * size,
            "phase_0": phases[0], "phase_1": phases[1], "period": [float(axes[0].period) if axes else 0.0] * size,
            "phase_unit": [axes[0].unit or "n/a" if axes else "n/a"] * size}


_COLUMNS = {
    "population": "name of the recorded array that the unit belongs to", "kind": "head direction, grid or other",
    "module": "number of the population, from 0", "phase_0": "preferred value along the first axis",
    "phase_1": "preferred value along the second axis; NaN where there is none",
    "period": "length of the first axis, after which it wraps around; 0 if it does not",
    "phase_unit": "unit of phases and period"}  # yapf: disable


def _write_head(writer, run, started):
    file, info = writer.file, run.info
    writer.mark(file, "NWBFile", nwb_version="2.6.0")
    writer.text("identifier", file.attrs["object_id"])
    writer.text("session_description", f"{info.get('name', run.path.name)}: {info.get('source', {}).get('description', '')}")
    writer.text("session_start_time", started)
    writer.text("timestamps_reference_time", started)
    file.create_dataset("file_create_date", data=np.array([started], dtype=object), dtype=_text_type(), maxshape=(None,))
    for group in ("acquisition", "analysis", "processing", "stimulus/presentation", "stimulus/templates", "general"):
        file.create_group(group)
    writer.text("general/experiment_description", "a run of Tolman: spatial cells of a robot; there is no animal")
    file.create_dataset("general/keywords", data=np.array(["spatial cells", "SLAM", "simulation"], dtype=object),
                        dtype=_text_type())
    writer.text("general/notes", json.dumps(info, sort_keys=True))
    resolved = run.path / "config.resolved.yaml"
    script = writer.text("general/source_script", resolved.read_text() if resolved.is_file() else "not recorded")
    script.attrs["file_name"] = "config.resolved.yaml"


def _text_type():
    import h5py

    return h5py.string_dtype()


def _write_behavior(writer, poses, seconds, of, metric):
    writer.module("behavior", f"position and head direction: {of}")
    place = "processing/behavior/Position"
    writer.mark(writer.file.create_group(place), "Position")
    xy = np.stack([poses["x"], poses["y"]], axis=1)
    unit = "meters" if metric else "arbitrary units"
    writer.series(f"{place}/position", "SpatialSeries", xy, unit, seconds, "x forward and y left of the first camera")
    writer.text(f"{place}/position/reference_frame", "the first camera: x along its optical axis, y to its left, in its plane")
    compass = "processing/behavior/CompassDirection"
    writer.mark(writer.file.create_group(compass), "CompassDirection")
    heading = np.asarray(poses["heading"]) % (2 * np.pi)
    writer.series(f"{compass}/head_direction", "SpatialSeries", heading, "radians", seconds, "direction of the optical axis")
    writer.text(f"{compass}/head_direction/reference_frame", "0 along the first camera's optical axis, counter-clockwise seen from above")


def _write_units(writer, run, origin_ns, peak_hz):
    arrays = _populations(run)
    if not arrays:
        return
    writer.module("rates", "firing rates of the units, one series for each population")
    rows, trains, seed = {name: [] for name in _COLUMNS}, [], int(run.info.get("seed", 1))
    for module, array in enumerate(arrays):
        rates, seconds = _rates(array, peak_hz), 1e-9 * (array.stamps_ns - origin_ns)
        series = f"processing/rates/{array.info.name.replace('/', '_')}"
        words = array.info.doc or f"rates of {array.info.name}, one column a unit"
        if rates is None:
            print(f"warning: {run.path}: '{array.info.name}' has values below 0, which are no firing rates; it has no units and no "
                  "spikes in the file", file=sys.stderr)
            flat = array.values.reshape(len(array.values), -1).astype(np.float32)
            writer.series(series, "TimeSeries", flat, array.unit or "arbitrary", seconds, f"{words} (no firing rates)")
            continue
        writer.series(series, "TimeSeries", rates.astype(np.float32), "hertz", seconds, words)
        for name, values in _unit_columns(array, module).items():
            rows[name] += list(values)
        trains += [spikes(unit, seconds, (seed, len(trains) + k)) for k, unit in enumerate(rates.T)]
    columns = {name: (rows[name], words) for name, words in _COLUMNS.items()}
    table = writer.table("units", "Units", "all recorded units with spikes drawn from their rates", columns,
                         {"spike_times": (trains, "spike times in seconds")})
    table["spike_times"].attrs["resolution"] = SPIKE_RESOLUTION_S


def _laps_of_sessions(poses, seconds):
    """Laps within each session: how the robot came from one to the next is not known."""
    x, y, session = (np.asarray(poses[name]) for name in ("x", "y", "session"))
    rounds = []
    for which in np.unique(session):
        own = session == which
        rounds += laps(x[own], y[own], seconds[own])
    return rounds


def _write_intervals(writer, run, poses, seconds, origin_ns):
    rounds = _laps_of_sessions(poses, seconds)
    if rounds:
        columns = {"start_time": ([lap[0] for lap in rounds], "start of the lap, s"),
                   "stop_time": ([lap[1] for lap in rounds], "end of the lap, s"),
                   "lap": (np.arange(len(rounds)), "number of the lap, from 0")}
        writer.table("intervals/trials", "TimeIntervals", "laps: rounds back to the start", columns)
    places = run.places
    places = rows_where(places, np.asarray(places["frame"]) >= run.first_measured)
    seen = [k for k, word in enumerate(places["recognition"]) if word != "none"]
    if not seen:
        return
    stamps = 1e-9 * (np.asarray(places["stamp_ns"]) - origin_ns)
    ends = np.append(stamps[1:], 2 * stamps[-1] - stamps[-2] if len(stamps) > 1 else stamps[-1] + 1)
    columns = {"start_time": (stamps[seen], "time of the view, s"), "stop_time": (ends[seen], "time of the next frame, s"),
               "recognition": ([str(places["recognition"][k]) for k in seen], "novel or familiar"),
               "template_id": (np.asarray(places["template_id"])[seen], "number of the local view template")}
    writer.table("intervals/views", "TimeIntervals", "views that were recognised or stored", columns)


def _contents(run, peak_hz):
    """The file in memory, for HDF5 crashes where a write to a file fails."""
    import h5py

    from tolman import _hdf5

    poses, frames = run.measured_poses(), run.frames
    if len(poses) < 2:
        raise ValueError(f"{run.path}: fewer than two frames have a pose; there is nothing to export")
    frames = rows_where(frames, np.asarray(frames["frame"]) >= run.first_measured)
    back = np.flatnonzero(np.diff(np.asarray(frames["stamp_ns"])) <= 0)
    if len(back) > 0:
        raise ValueError(f"{run.path}: the times of frame {frames['frame'][back[0] + 1]} and the frame before it, which is of "
                         "another session, do not increase, and run.nwb has one clock; set evaluation.sessions to own")
    origin_ns = int(frames["stamp_ns"][0])
    seconds = 1e-9 * (np.asarray(poses["stamp_ns"]) - origin_ns)
    started = run.info.get("started", "1980-01-01T00:00:00Z").replace("Z", "+00:00")
    of = "true poses" if frames["has_truth"].max() else "poses of the finished map"
    memory = io.BytesIO()
    with h5py.File(memory, "w", libver=("v108", "v110"), track_order=False) as file:
        writer = _hdf5.Writer(file, f"{run.info.get('name')} {started} {json.dumps(run.info.get('plugins'))}")
        _write_head(writer, run, started)
        _write_behavior(writer, poses, seconds, of, frames["has_truth"].max() or run.scale_known)
        _write_units(writer, run, origin_ns, peak_hz)
        _write_intervals(writer, run, poses, seconds, origin_ns)
    return memory.getbuffer()


def export(run, out=None, peak_hz=PEAK_HZ):
    """Writes a Run to an NWB file, by default run.nwb in its directory; gives the path. An existing file is replaced.

    Of a run that goes on: its state of one moment. ValueError if `peak_hz` is no positive number.
    """
    if not (peak_hz > 0 and np.isfinite(peak_hz)):
        raise ValueError(f"peak_hz is {peak_hz}; give a positive number of Hz")
    out = pathlib.Path(out) if out else run.path / "run.nwb"
    with run.one_state():
        contents = _contents(run, peak_hz)
    with written(out), replacing(out) as unfinished:
        unfinished.write_bytes(contents)
    return out


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="tolman export --nwb", description=__doc__.split("\n")[0])
    parser.add_argument("run")
    parser.add_argument("out", nargs="?")
    add_output_options(parser)
    parser.add_argument("--peak-hz", type=float, default=PEAK_HZ)
    given = parser.parse_args(arguments)
    return exit_code_of(lambda: write_output(given, given.out, lambda: export(Run(given.run), given.out, given.peak_hz)))


if __name__ == "__main__":
    sys.exit(main())
