# SPDX-License-Identifier: BSD-3-Clause
"""Measures the cells of a sweep such as configs/experiments/models.yaml: the tables and the figure of docs/results.md.

  python3 -m tolman.comparison sweeps/study [--out FOLDER] [--force] [--cost N]

Writes models.csv, models-cells.csv and models.svg into the folder of the sweep. The sequence `box` is for measures of single units, `rooms` and
`reported` for remapping and relocation, `eights` for the stability of two passes; others give metres only. A measure of units is the median over 40 of
the first population; of several seeds the mean, with the smallest and the largest. --cost N only measures the time of a step again: the runs in
the box with the first seed, N times each, one at a time; the smallest of the N medians takes the place of the one in the table, for other
programs only add to it.
"""
import argparse
import concurrent.futures
import csv
import math
import pathlib
import sys
import tempfile

import numpy as np

import tolman
from tolman import cells, program, spatial
from tolman._files import refuse_existing, refuse_run_places

METRICS = ("map.ate.rmse_m", "loops.true_links", "loops.false_links", "odometry.ate.rmse_m")
BIN_M, SIDE_M, UNITS = 0.5, 15, 40
FOLLOWS_M, PASS_M = 1.0, 3.0
NEAR_M = 3.0  # a link is right when the experience was made so near: spacing and view radius of 1 m each, and a step
GRID = {"sargolini": "Sargolini", "langston": "Langston", "square": "square", "information_bits": "bits a spike", "stability": "stability"}
COST = "ms a step"
WRITTEN = ("models.csv", "models-cells.csv", "models.svg")
FIELDS = {"spacing_m": "spacing, m", "field_m2": "field, m2", "fields": "fields"}


def points(folder):
    """Runs by (model, sequence), in the order of their seeds."""
    found = {}
    for factors, run in tolman.Sweep(folder).runs:
        if "model" not in factors or "sequence" not in factors:
            raise ValueError(f"{folder}: its sweep has no factor 'model' or no 'sequence' to compare by; see docs/results.md")
        found.setdefault((factors["model"], factors["sequence"]), []).append((int(factors.get("seed", 1)), run))
    return {point: [run for _, run in sorted(runs, key=lambda item: item[0])] for point, runs in found.items()}


def population(run):
    """The first population of cells of position: `grid.activity` or `place.activity`, else one of that kind that is not described as a ring."""
    described = [name for name, info in run.descriptions.items() if info.kind == "activity" and len(info.axes) != 1]
    for name in ("grid.activity", "place.activity", *described):
        if name in run.arrays:
            return name
    raise ValueError(f"{run.path}: no array of kind 'activity' with two axes to measure; recorded are {', '.join(run.arrays) or 'none'}")


def median(values):
    known = np.asarray(values, float)[np.isfinite(values)]
    return float(np.median(known)) if len(known) else float("nan")


def single_units(run):
    """(table, measure, value, chance), of the box."""
    scores = run.scores(population(run), bin_m=BIN_M, units=UNITS)
    for key, words in GRID.items():
        yield "grid", words, median(scores[key]), median(scores[key + "_chance"])
    for key, words in FIELDS.items():
        yield "fields", words, median(scores[key]), None
    if "hd.activity" in run.arrays:
        tuning = run.tuning("hd.activity")
        yield "fields", "head direction: mean vector", median(tuning.mean_vector_length), None
        yield "fields", "half width, rad", median([spatial.half_width(curve) for curve in tuning.values.reshape(-1, len(tuning.heading_rad))]), None
    yield "fields", COST, step_ms(run), None


def visits_of(x):
    """Frames of the three visits: first room, second room, first room again."""
    room = np.round(x / (2 * SIDE_M))
    moves = np.flatnonzero(np.diff(room)) + 1
    return np.split(np.arange(len(x)), moves), room


def room_maps(run):
    """Rate maps of the three visits in the coordinates of the room: visits x units x bins."""
    x, y, _, rates = run._walk(run.array(population(run)))
    visits, room = visits_of(x)
    chosen = np.unique(np.linspace(0, rates.shape[1] - 1, min(UNITS, rates.shape[1])).astype(int))
    bins = round(SIDE_M / BIN_M)
    row, column = (np.clip(np.floor((at + SIDE_M / 2) / BIN_M).astype(int), 0, bins - 1) for at in (x - 2 * SIDE_M * room, y))
    return [cells._means(row[own] * bins + column[own], rates[own][:, chosen], bins * bins)[0] for own in visits]


def rooms(run):
    """(table, measure, value, chance): of 0 and 1, a code that remaps is at chance in the other room."""
    first, other, again = room_maps(run)
    units = range(len(first))
    for words, second in (("other room", other), ("first room again", again)):
        same = [spatial.correlation(first[i], second[i]) for i in units]
        strangers = [value for i in units for j in units if i != j and np.isfinite(value := spatial.correlation(first[i], second[j]))]
        yield "rooms", words, median(same), float(np.percentile(strangers, 95)) if strangers else None
    yield from relocation(run, "relocation")


def reported(run):
    """The same walk where motion says that the animal is carried."""
    yield from relocation(run, "relocation reported")


def relocation(run, table):
    """After the return into the first room: the first loop link that is right and leads to the first visit, how many there are, how many links
    lead to another place, and whether the map follows."""
    truth, decisions = run.trajectory("truth"), run.decisions
    x, y = (dict(zip(truth["frame"], truth[axis])) for axis in ("x", "y"))
    seconds = dict(zip(truth["frame"], np.asarray(truth["stamp_ns"]) * 1e-9))
    (first, _, again), _ = visits_of(np.asarray(truth["x"]))
    last, begin = truth["frame"][first[-1]], truth["frame"][again[0]]
    rows = list(zip(decisions["frame"], decisions["action"], decisions["experience"]))
    made = {experience: frame for frame, action, experience in reversed(rows) if action == "create_experience"}
    right, wrong = [], 0
    for frame, action, experience in rows:
        if action == "close_loop" and frame >= begin:
            far = np.hypot(x[frame] - x[made[experience]], y[frame] - y[made[experience]]) > NEAR_M
            wrong += bool(far)
            right += [frame] if not far and made[experience] <= last else []
    yield table, "relocated", float(bool(right)), None
    yield table, "after, s", float(seconds[right[0]] - seconds[begin]) if right else float("nan"), None
    yield table, "right links", float(len(right)), None
    yield table, "wrong links", float(wrong), None
    yield table, "map within 1 m, %", 100 * follows(run, first, again), None


def follows(run, first, again):
    """Share of the frames after the return at which the position that the map gave then, fitted to the truth of the first visit, is right within
    FOLLOWS_M."""
    truth, known = run.trajectory("truth"), run.map
    map_m = np.stack([known["T_world_camera_z"], -np.asarray(known["T_world_camera_x"])], axis=1)
    true_m = np.stack([truth["x"], truth["y"]], axis=1)
    map_mean, true_mean = map_m[first].mean(axis=0), true_m[first].mean(axis=0)
    u, _, v = np.linalg.svd((map_m[first] - map_mean).T @ (true_m[first] - true_mean))
    turn = v.T @ np.diag([1, np.linalg.det(v.T @ u.T)]) @ u.T
    off = (map_m[again] - map_mean) @ turn.T + true_mean - true_m[again]
    return float(np.mean(np.hypot(*off.T) < FOLLOWS_M))


def passes(run):
    """(table, measure, value, chance): rates of a unit along the way that is driven twice in the same direction, first pass against the next;
    chance is the 95th percentile of second passes that are shifted by a tenth or more."""
    x, y, heading, rates = run._walk(run.array(population(run)))
    chosen = np.unique(np.linspace(0, rates.shape[1] - 1, min(UNITS, rates.shape[1])).astype(int))
    earlier, later = twice(x, y, heading)
    one, two = rates[earlier][:, chosen], rates[later][:, chosen]
    rng, same, shifted = np.random.default_rng(1), [], []
    for a, b in zip(one.T, two.T):
        if np.std(a) > 0 and np.std(b) > 0:
            same.append(float(np.corrcoef(a, b)[0, 1]))
            by = rng.integers(len(b) // 10, len(b) - len(b) // 10)
            shifted.append(float(np.corrcoef(a, np.roll(b, by))[0, 1]))
    yield "passes", "two passes", median(same), float(np.percentile(shifted, 95)) if shifted else None
    yield "passes", "units that fire in both", float(len(same)), None
    yield "passes", "share of units above zero, %", 100 * float(np.mean(rates > 0)), None


def twice(x, y, heading):
    """Indices of the moments at which the way is one that was driven before (PASS_M near, 20 degrees), and of the nearest earlier one."""
    path = np.concatenate([[0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    earlier, later = [], []
    for i in range(len(x)):
        old = np.searchsorted(path, path[i] - 50)  # m: not the way just driven
        far = np.hypot(x[:old] - x[i], y[:old] - y[i])
        far[np.cos(heading[:old] - heading[i]) < math.cos(math.radians(20))] = np.inf
        if len(far) and far.min() < PASS_M:
            earlier.append(int(np.argmin(far)))
            later.append(i)
    return earlier, later


def name_of(model):
    """Of a level of the sweep: without its lengths, such as "ssp, 4 m"."""
    return model.split(",")[0]


def write_metres(file, sweep):
    """What `tolman sweep collect` says, but of the rooms: where one lies relative to the other is not observable, so no map has the right shape."""
    program.call("sweep", "collect", sweep, "--force", "--out", file, *(word for metric in METRICS for word in ("--metric", metric)))
    with open(file, newline="") as stream:
        header, *rows = csv.reader(stream)
    kept = []
    for row in (dict(zip(header, row)) for row in rows):
        if row["sequence"] in ("rooms", "reported"):
            continue
        own_truth = row["sequence"] == "box"  # each seed walks its own way; `tolman compare` expects one of a sequence
        kept.append(list({**row, "model": name_of(row["model"]), "truth_sha256": "" if own_truth else row["truth_sha256"]}.values()))
    with open(file, "w", newline="") as stream:
        csv.writer(stream, lineterminator="\n").writerows([header, *kept])


MEASURES = {"box": single_units, "rooms": rooms, "reported": reported, "eights": passes}


def measured(job):
    """In a process of its own."""
    _, sequence, path = job
    return list(MEASURES[sequence](tolman.Run(path)))


def over_seeds(rows):
    """(table, measure, mean, smallest, largest, chance) of the rows of several runs, one a seed."""
    found = {}
    for table, measure, value, chance in rows:
        found.setdefault((table, measure), []).append((value, np.nan if chance is None else chance))
    for (table, measure), pairs in found.items():
        values, chances = (np.array(column)[np.isfinite(column)] for column in zip(*pairs))
        if len(values):
            yield table, measure, values.mean(), values.min(), values.max(), chances.mean() if len(chances) else np.nan


def step_ms(run):
    timing = run.timing
    return float(np.median(np.asarray(timing["duration_ns"])[np.asarray(timing["stage"]) == "cells"])) * 1e-6


def renew_cost(file, sweep, times):
    """The rows "ms a step" of the table."""
    with open(file, newline="") as stream:
        header, *rows = csv.reader(stream)
    for (model, sequence), runs in points(sweep).items():
        if sequence != "box":
            continue
        found = []
        for _ in range(times):
            with tempfile.TemporaryDirectory() as folder:
                program.call("rerun", runs[0].path, "--out", pathlib.Path(folder) / "again")
                found.append(step_ms(tolman.Run(pathlib.Path(folder) / "again")))
        print(f"{name_of(model)}: " + ", ".join(f"{value:.4f}" for value in found), flush=True)
        for row in rows:
            if row[header.index("model")] == name_of(model) and row[header.index("measure")] == COST:
                for column, value in (("value", min(found)), ("least", min(found)), ("most", max(found))):
                    row[header.index(column)] = f"{value:.4g}"
    with open(file, "w", newline="") as stream:
        csv.writer(stream, lineterminator="\n").writerows([header, *rows])


def write_cells(file, rows):
    """In the form of `tolman sweep collect`, so that `tolman compare` reads it: a row for each model and measure."""
    with open(file, "w", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(["name", "model", "table", "measure", "alignment", "truth_sha256", "results_sha256", "value", "least", "most", "chance"])
        for model, (table, measure, *numbers) in rows:
            text = [f"{number:.4g}" if np.isfinite(number) else "" for number in numbers]
            writer.writerow([f"{model}, {table}: {measure}", name_of(model), table, measure, "", "", "", *text])


def picture(maps):
    """Rate maps of one unit of each model: a path for each of nine shades."""
    parts, side = [], 150
    for k, (name, values) in enumerate(maps.items()):
        units = values.reshape(-1, *values.shape[-2:])
        unit = units[np.argmax(np.nanmax(units, axis=(1, 2)))]
        parts.append(f'<text x="{k * (side + 12) + 2}" y="12" font-family="sans-serif" font-size="12">{name}</text>')
        parts.append(f'<g transform="translate({k * (side + 12)} 18) scale({side / max(unit.shape):.4f})">')
        shades = np.where(np.isfinite(unit), np.round(8 * unit / max(np.nanmax(unit), 1e-12)), -1)
        for shade in range(9):  # x forward is up, y left is left
            bins = np.argwhere(shades[::-1, ::-1] == shade)
            level = round(255 * (1 - shade / 8))
            path = "".join(f"M{j} {i}h1v1h-1z" for i, j in bins)
            parts.append(f'<path fill="rgb({level},{level},255)" d="{path}"/>')
        parts.append("</g>")
    size = f'width="{len(maps) * (side + 12)}" height="{side + 24}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size}>' + "\n".join(parts) + "</svg>\n"


def write(sweep, tables, images):
    """Both tables, and the figure."""
    tables.mkdir(parents=True, exist_ok=True)
    jobs, maps = [], {}
    for (model, sequence), runs in points(sweep).items():
        if sequence == "box":
            maps[name_of(model)] = runs[0].rate_maps(population(runs[0]), BIN_M).values
        jobs += [(model, sequence, run.path) for run in runs if sequence in MEASURES]
    with concurrent.futures.ProcessPoolExecutor() as pool:
        found = {}
        for (model, sequence, _), measures in zip(jobs, pool.map(measured, jobs)):
            found.setdefault((model, sequence), []).extend(measures)
    if not found:
        raise ValueError(f"{sweep}: no run is done on one of the measured sequences: {', '.join(MEASURES)}")
    rows = [(model, row) for (model, _), measures in found.items() for row in over_seeds(measures)]
    write_metres(tables / "models.csv", sweep)
    write_cells(tables / "models-cells.csv", rows)
    (images / "models.svg").write_text(picture(maps))
    print(f"{tables / 'models.csv'}\n{tables / 'models-cells.csv'}\n{images / 'models.svg'}")


def main(docs=None):
    """`docs`: the folder that has the page; --write is offered with it."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("sweep", type=pathlib.Path)
    options.add_argument("--out", type=pathlib.Path, help="folder of tables and figure (default: the one of the sweep)")
    options.add_argument("--force", action="store_true", help="replace the files of --out")
    options.add_argument("--cost", type=int, metavar="N", help="only measure the time of a step again, N times")
    if docs:
        options.add_argument("--write", action="store_true", help="into docs/tables and docs/images")
    chosen = options.parse_args()
    into_docs = docs and chosen.write
    tables = docs / "tables" if into_docs else chosen.out or chosen.sweep
    try:
        if chosen.cost:
            renew_cost(tables / "models-cells.csv", chosen.sweep, chosen.cost)
        else:
            own = into_docs or not chosen.out
            refuse_run_places(tables / WRITTEN[0], None, "choose another --out")
            refuse_existing([tables / name for name in WRITTEN], own or chosen.force, "choose another --out")
            write(chosen.sweep, tables, docs / "images" if into_docs else tables)
    except (OSError, ValueError) as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main()
