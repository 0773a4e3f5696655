# SPDX-License-Identifier: BSD-3-Clause
"""Results of a real run against what its files say, and measures of cells against activity that is known."""
import fcntl
import json
import math
import os
import pathlib
import re
import sqlite3
import unittest
import unittest.mock

from support import ROOT, Systems, tolman as tolman_program

import numpy as np

import tolman
from tolman import cells, npz, results


class MeasuresTest(unittest.TestCase):
    def test_a_rate_map_finds_the_field(self):
        rng = np.random.default_rng(5)
        x, y = rng.uniform(-1, 3, 20000), rng.uniform(0, 2, 20000)
        rates = np.stack([(x > 1) & (x < 1.5) & (y < 0.5), np.full(x.shape, 4.0)], axis=1).astype(float)
        maps = cells.rate_maps(x, y, rates, (2,), 0.5)
        self.assertEqual(maps.values.shape, (2, 8, 4))
        self.assertEqual(maps.visits.sum(), 20000)
        self.assertEqual(np.argwhere(maps.values[0] > 0).tolist(), [[4, 0]])
        self.assertEqual(maps.values[0, 4, 0], 1)
        self.assertTrue((maps.values[1] == 4).all())
        self.assertEqual((maps.x_m[4], maps.y_m[0]), (1, 0))

    def test_bins_without_visits_are_not_numbers(self):
        maps = cells.rate_maps(np.array([0.1, 2.1]), np.array([0.1, 0.1]), np.ones((2, 1)), (1,), 1)
        self.assertTrue(np.array_equal(maps.values[0, :, 0], [1, np.nan, 1], equal_nan=True))

    def test_a_tuning_curve_has_the_preferred_direction_and_length(self):
        heading = np.linspace(0, 2 * math.pi, 36000, endpoint=False) + 0.01
        rates = np.stack([1 + np.cos(heading - 2), np.ones_like(heading)], axis=1)
        curves = cells.tuning(heading - 4 * math.pi, rates, (2,), 36)
        self.assertAlmostEqual(curves.preferred_rad[0], 2, places=2)
        self.assertAlmostEqual(curves.mean_vector_length[0], 0.5, places=2)  # of a cosine
        self.assertAlmostEqual(curves.mean_vector_length[1], 0, places=6)

    def test_phases_wrap_around(self):
        axis = tolman.ArrayAxis("heading", "rad", 5, 1, 6)
        array = cells.Array(tolman.ArrayInfo(axes=[axis]), np.zeros(1), np.zeros(1), np.zeros((1, 4)))
        self.assertEqual(array.phases[0].tolist(), [5, 0, 1, 2])
        self.assertEqual(array.periods, [6])


class RunTest(Systems):
    @classmethod
    def declared_units(cls):
        """(column, unit) of the plain fields in the reference of the record."""
        text = (ROOT / "docs/reference/records.md").read_text()
        return re.findall(r"^\| `?(\w+)`? \|[^|]*\| ([^|]*) \|", text, re.MULTILINE)

    def made(self):
        ran = self.run_system()
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return tolman.Run(self.folder / "run")

    def test_figures_of_a_continued_run_are_of_its_own_session(self):
        """The truth of each session begins at its own first frame; together they are no path."""
        self.made()
        words = ["--continue", self.folder / "run", "--set", "source.first=10"]
        self.assertEqual(self.run_system(*words, out="second").returncode, 0)
        run = tolman.Run(self.folder / "second")
        poses = run.trajectory()
        self.assertEqual(sorted(set(poses["session"])), [0, 1])
        first = int(np.asarray(poses["frame"])[np.asarray(poses["session"]) == 1][0])
        self.assertEqual(run.first_measured, first)
        self.assertEqual(list(run.measured_poses()["frame"]), [frame for frame in run.trajectory("best")["frame"] if frame >= first])
        self.assertEqual(run.rate_maps("grid.activity").visits.sum(), sum(frame >= first for frame in run.array("grid.activity").frames))
        config = run.path / "config.resolved.yaml"
        config.write_text(config.read_text().replace("sessions: own", "sessions: joint"))
        self.assertEqual(tolman.Run(run.path).first_measured, 0)

    def test_a_run_directory_may_have_any_name(self):
        """'?', '#' and '%41' mean something in the address by which SQLite opens a file."""
        run = self.made()
        for name in ("what?x", "#hash", "x%41", "two words"):
            folder = run.path.parent / name
            run.path.rename(folder)
            self.assertEqual(len(tolman.Run(folder).motion), 25)
            self.assertEqual(sorted(entry.name for entry in folder.parent.iterdir() if entry.name.startswith("what")),
                             ["what?x"] if name == "what?x" else [])
            folder.rename(run.path)

    def test_tables_arrays_and_files_of_a_run(self):
        run = self.made()
        database = sqlite3.connect(self.folder / "run/run.sqlite")
        self.assertEqual(len(run.motion), 25)
        self.assertEqual(list(run.decisions["action"]),
                         [row[0] for row in database.execute("SELECT action FROM decision ORDER BY frame")])
        self.assertEqual(run.covariances("motion").shape, (25, 6, 6))
        self.assertEqual(run.metrics, json.loads((self.folder / "run/metrics.json").read_text()))
        self.assertEqual(run.info["counters"]["frames"], 25)
        for name in run.arrays:
            array = run.array(name)
            self.assertEqual(array.values.shape[0], 25)
            self.assertEqual(list(array.frames), list(range(25)))
            self.assertEqual(len(array.axes), len(run.descriptions[name].axes))
        with self.assertRaisesRegex(KeyError, "no array 'none'"):
            run.array("none")
        with self.assertRaisesRegex(KeyError, "no table 'none'"):
            run.table("none")

    def test_the_trajectory_is_that_of_the_exported_file(self):
        run = self.made()
        lines = [[float(word) for word in line.split()]
                 for line in (self.folder / "run/trajectory.tum").read_text().splitlines() if line[0] != "#"]
        poses = run.trajectory()
        self.assertTrue(np.allclose(poses["x"], [line[3] for line in lines]))
        self.assertTrue(np.allclose(poses["y"], [-line[1] for line in lines]))
        turned = np.unwrap(np.asarray(poses["heading"]))
        self.assertAlmostEqual(turned[-1], 2 * math.pi, delta=0.2)  # once round, to the left

    def test_a_folder_without_a_run_is_refused(self):
        with self.assertRaisesRegex(FileNotFoundError, "no run.sqlite"):
            tolman.Run(self.folder)
        (self.folder / "run.sqlite").touch()  # as a run creates it
        with self.assertRaisesRegex(ValueError, "has no table 'run': it is no record of a run"):
            tolman.Run(self.folder)

    def test_a_record_that_was_changed_after_its_run_is_refused(self):
        run = self.made()
        file = run.path / "run.sqlite"
        with sqlite3.connect(file) as database:
            database.execute("DELETE FROM motion WHERE frame > 19")
        with self.assertRaisesRegex(ValueError, "run.sqlite: is not what the run wrote"):
            tolman.Run(run.path)
        self.assertIn("run.sqlite: is not what the run wrote", tolman_program("report", run.path).stderr)
        descriptor = os.open(run.path, os.O_RDONLY)  # as a run that is resumed holds it
        self.addCleanup(os.close, descriptor)
        fcntl.flock(descriptor, fcntl.LOCK_EX)
        self.assertEqual(len(tolman.Run(run.path).motion), 20)
        fcntl.flock(descriptor, fcntl.LOCK_UN)
        (run.path / "run.sqlite-wal").write_bytes(b"of a copy that was made during the run")
        with self.assertRaisesRegex(ValueError, "run.sqlite-wal: is not what the run wrote"):
            tolman.Run(run.path)

    def test_lengths_are_in_units_where_the_scale_is_unknown(self):
        run = self.made()
        if not hasattr(run.motion, "attrs"):
            self.skipTest("needs python3-pandas")
        self.assertEqual(run.motion.attrs["units"]["v"], "m/s")
        with unittest.mock.patch.object(tolman.Run, "scale_known", False):
            units = json.loads(str(np.load(npz.write(run.path))["units"]))
            for name in ("frame", "motion", "place", "decision", "map_update", "experience", "link"):
                told = run.table(name).attrs["units"]
                renamed = lambda column: npz._RENAMED.get((name, column), column)
                self.assertEqual(told, {column: units.get(f"{name}/{renamed(column)}", "") for column in told}, name)
            self.assertEqual(run.motion.attrs["units"]["v"], "units/s")
            self.assertEqual(run.frames.attrs["units"]["T_world_camera_truth_x"], "m")
            self.assertEqual(run.trajectory("truth").attrs["units"]["x"], "m")
            self.assertEqual(run.trajectory().attrs["units"]["x"], "units")

    def test_an_ended_run_without_metrics_is_told_and_a_running_one_has_none_yet(self):
        run = self.made()
        (run.path / "metrics.json").unlink()
        with self.assertRaisesRegex(FileNotFoundError, "metrics.json: is missing, although the run has ended"):
            tolman.Run(run.path).metrics
        info = json.loads((run.path / "run.json").read_text())
        (run.path / "run.json").write_text(json.dumps({**info, "status": "running"}))
        self.assertEqual(tolman.Run(run.path).metrics, {})

    def test_damaged_files_are_named(self):
        run = self.made()
        for name, text in (("metrics.json", "{"), ("metrics.json", "[]"), ("run.json", "x")):
            (run.path / name).write_text(text)
            with self.assertRaisesRegex(ValueError, name + ": is damaged"):
                tolman.Run(run.path).metrics

    def test_runs_from_python(self):
        config = self.config()
        run = tolman.run(config, set={"seed": 3, "cells": {"plugin": "bayesian_attractor"}}, out=self.folder / "a")
        self.assertEqual(len(run.motion), 25)
        with self.assertRaisesRegex(tolman.RunFailed, "did you mean") as failed:
            tolman.run(config, set={"cells.plugin": "bayesian_atractor"}, out=self.folder / "b")
        self.assertEqual(failed.exception.code, 4)

    def test_values_of_a_run_are_written_as_yaml_or_refused(self):
        from tolman.program import _text

        self.assertEqual(_text({"a": [None, True, np.float64(0.5), np.int64(3), np.bool_(False)], "b": np.arange(2)}),
                         "{a: [null, true, 0.5, 3, false], b: [0, 1]}")
        self.assertEqual(_text([pathlib.Path("/a b"), "word", "-0.5", "~"]), '["/a b", word, -0.5, "~"]')
        config = self.config()
        for value in ({1, 2}, b"x", 3j, object(), [{"a"}]):
            with self.assertRaisesRegex(TypeError, "set: 'seed': .*of type"):
                tolman.run(config, set={"seed": value})
        for value in (math.nan, np.float32("inf"), [1, -math.inf]):
            with self.assertRaisesRegex(ValueError, "set: 'seed': .*finite"):
                tolman.run(config, set={"seed": value})
        with self.assertRaisesRegex(TypeError, "not list"):
            tolman.run(config, set=["seed=3"])
        with self.assertRaisesRegex(tolman.RunFailed, "name=null: name: expects a text, not nothing"):
            tolman.run(config, set={"name": None}, out=self.folder / "c")

    def test_a_text_is_this_text(self):
        """Whatever YAML would read in it."""
        config = self.config()
        names = ("null", "~", "a: b", "run #5", '"q"', "'", "|", "- a", "[1, 2]", "back\\slash", " blank ", "é", "true", "30")
        for i, name in enumerate(names):
            self.assertEqual(tolman.run(config, set={"name": name}, out=self.folder / f"text{i}").info["name"], name)
        run = tolman.run(config, set={"source.last": "9"}, out=self.folder / "number")  # a number as a text
        self.assertEqual(len(run.motion), 10)

    def test_structured_arrays_without_pandas(self):
        import sys

        run = self.made()
        kept, sys.modules["pandas"] = sys.modules.get("pandas"), None
        try:
            self.assertEqual(run.motion.dtype.names[:2], ("frame", "stamp_ns"))
        finally:
            sys.modules.pop("pandas")
            if kept is not None:
                sys.modules["pandas"] = kept

    def test_units_are_those_of_the_reference(self):
        checked = 0
        for column, unit in self.declared_units():
            if unit.strip() in ("s", "m/s", "rad/s", "rad", "px", "ns") and "T_" not in column:
                self.assertEqual(results.unit_of(column), unit.strip(), column)
                checked += 1
        self.assertGreater(checked, 10)


if __name__ == "__main__":
    unittest.main()
