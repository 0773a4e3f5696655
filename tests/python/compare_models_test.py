# SPDX-License-Identifier: BSD-3-Clause
"""The comparison of models on a small sweep: its tables, and what `tolman compare` makes of them."""
import csv
import os
import re
import subprocess
import sys
import types
import unittest

from support import BUILD, ROOT, Systems, tolman as program

import numpy as np

import tolman
from tolman import comparison, models

WALK = """source: {{plugin: python, file: {trajectory}, side: 15, speed: 2, view_radius: 1, rooms: {rooms}, duration: {duration}, reported: {reported}}}
    record.arrays_every: 1"""


class CompareModelsTest(Systems):
    def setUp(self):
        super().setUp()
        self.config(odometry="{plugin: motion_replay}", place="{plugin: place_replay, relative_pose: true, view_step: 1000}")
        walks = {name: WALK.format(trajectory=models.path("trajectory"), rooms=rooms, duration=duration, reported=reported)
                 for name, rooms, duration, reported in (("box", 1, 150, "false"), ("rooms", 2, 240, "false"), ("reported", 2, 240, "true"))}
        lengths = "experience_spacing: 1, loop_spacing: 1, loop_minimum_travel: 10"
        self.study = self.folder / "study.yaml"
        self.study.write_text(f"""base: system.yaml
list:
  model:
    "ssp, 4 m": {{cells: {{plugin: python, file: {models.path("ssp")}, spacing: 4, agreement: 1, {lengths}}}}}
    "bayesian_attractor, 4 m": {{cells: {{plugin: bayesian_attractor, period: 4, drift_position: 0.01, {lengths}}}}}
sequences:
  box:
    {walks["box"]}
  rooms:
    {walks["rooms"]}
  reported:
    {walks["reported"]}
""")

    def test_its_tables_tell_hexagons_from_squares_and_who_relocates(self):
        swept = program("sweep", self.study, "--out", self.folder / "sweep")
        self.assertEqual(swept.returncode, 0, swept.stderr)
        done = subprocess.run([sys.executable, "-m", "tolman.comparison", self.folder / "sweep"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / "sweep/models-cells.csv", newline="") as file:
            listed = list(csv.DictReader(file))
        rows = {(row["model"].split(",")[0], row["measure"]): float(row["value"]) for row in listed if row["table"] != "relocation reported"}
        reported = {(row["model"].split(",")[0], row["measure"]): float(row["value"]) for row in listed if row["table"] == "relocation reported"}
        self.assertGreater(rows["ssp", "Sargolini"], 0.8)
        self.assertLess(rows["bayesian_attractor", "Sargolini"], 0)
        self.assertGreater(rows["bayesian_attractor", "square"], 0.8)
        for model in ("ssp", "bayesian_attractor"):
            self.assertLess(abs(rows[model, "other room"]), 0.3)
        self.assertGreater(rows["bayesian_attractor", "right links"], 0)
        self.assertLess(rows["bayesian_attractor", "after, s"], 80)
        self.assertEqual(rows["ssp", "right links"], 0)  # it has one hypothesis, and that is elsewhere
        self.assertNotIn(("ssp", "after, s"), rows)
        for model in ("ssp", "bayesian_attractor"):
            self.assertLess(rows[model, "map within 1 m, %"], 20)  # the map believes the motion
            self.assertEqual(reported[model, "relocated"], 1)
            self.assertGreater(reported[model, "map within 1 m, %"], 60)  # nothing contradicts the links
        self.assertIn("<svg", (self.folder / "sweep/models.svg").read_text())

        again = subprocess.run([sys.executable, "-m", "tolman.comparison", self.folder / "sweep", "--cost", "2"], capture_output=True, text=True, check=False)
        self.assertEqual(again.returncode, 0, again.stderr)
        with open(self.folder / "sweep/models-cells.csv", newline="") as file:
            renewed = list(csv.DictReader(file))
        for before, after in zip(listed, renewed):
            if before["measure"] == "ms a step":
                self.assertLess(float(after["value"]), float(after["most"]) + 1e-9)
                self.assertIn(before["model"] + ": ", again.stdout)
            else:
                self.assertEqual(before, after)

        table = program("compare", self.folder / "sweep/models-cells.csv", "--by", "model", "--columns", "measure", "--only", "table=grid",
                        "--cell", "{value:.2f} ({chance:.2f})")
        self.assertEqual(table.returncode, 0, table.stderr)
        self.assertIn("| Sargolini | Langston | square |", table.stdout)
        metres = program("compare", self.folder / "sweep/models.csv", "--by", "model", "--columns", "sequence", "--cell", "{loops.true_links:.0f}")
        self.assertEqual(metres.returncode, 0, metres.stderr)

    def test_the_page_leads_from_a_model_to_the_tables(self):
        """The model, the study and the commands of docs/python.md, with a walk of 150 s instead of 600."""
        page = (ROOT / "docs/python.md").read_text(encoding="utf-8")
        self.write("hexagons.py", re.search(r"```python\n(import math.*?)```", page, re.DOTALL)[1])
        study = re.search(r"```yaml\n(base: motion.*?)```", page, re.DOTALL)[1]
        self.write("study.yaml", study.replace("view_radius: 1}", "view_radius: 1, duration: 150}"))
        commands = re.search(r"```sh\n(export PYTHONPATH=.*?)```", page, re.DOTALL)[1].split("\n", 1)[1]  # this process has that path
        path = f"{BUILD / 'bin'}:/usr/bin:/bin"
        done = subprocess.run(["/bin/sh", "-ec", commands], capture_output=True, text=True, check=False, cwd=self.folder, env={**os.environ, "PATH": path})
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = {row[1]: row[2:-1] for row in (line.split("|") for line in done.stdout.replace(" ", "").splitlines() if line.startswith("|"))}
        self.assertEqual(len(rows["hexagons"]), 5)  # the last table: Sargolini, Langston, square, bits, stability
        self.assertGreater(float(rows["hexagons"][0].split("(")[0]), 0.5)
        self.assertGreater(float(rows["can_sheet"][0].split("(")[0]), 0.5)

    def test_the_population_is_found_by_name_or_description(self):
        described = {"hd": tolman.ArrayInfo("hd", "activity", axes=[tolman.ArrayAxis("heading")]),
                     "mine": tolman.ArrayInfo("mine", "activity", axes=[tolman.ArrayAxis("u"), tolman.ArrayAxis("v")])}
        run = types.SimpleNamespace(path="r", arrays=["hd", "mine"], descriptions=described)
        self.assertEqual(comparison.population(run), "mine")
        run.arrays = ["grid.activity", "mine"]
        self.assertEqual(comparison.population(run), "grid.activity")
        run.arrays = ["hd"]
        with self.assertRaisesRegex(ValueError, "r: no array of kind 'activity' with two axes to measure; recorded are hd"):
            comparison.population(run)

    def test_seeds_become_a_mean_and_its_range(self):
        rows = [("grid", "a", 1.0, 0.2), ("grid", "a", 3.0, 0.4), ("grid", "b", float("nan"), None), ("grid", "b", 5.0, None), ("grid", "c", float("nan"), None)]
        table = {measure: numbers for _, measure, *numbers in comparison.over_seeds(rows)}
        self.assertTrue(np.allclose(table["a"], [2, 1, 3, 0.3]))
        self.assertTrue(np.allclose(table["b"][:3], 5))
        self.assertTrue(np.isnan(table["b"][3]))
        self.assertNotIn("c", table)

    def test_a_way_is_driven_twice_where_place_and_direction_come_again(self):
        x = np.concatenate([np.arange(100.0), np.arange(100.0)])  # 100 m, and the same again
        earlier, later = comparison.twice(x, np.zeros(200), np.zeros(200))
        self.assertEqual(list(zip(earlier, later))[-1], (99, 199))
        self.assertTrue(all(b - a == 100 for a, b in zip(earlier, later)))
        back = np.concatenate([np.arange(100.0), np.arange(99.0, -1, -1)])
        self.assertEqual(comparison.twice(back, np.zeros(200), np.repeat([0, np.pi], 100)), ([], []))


if __name__ == "__main__":
    unittest.main()
