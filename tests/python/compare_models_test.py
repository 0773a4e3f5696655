# SPDX-License-Identifier: BSD-3-Clause
"""The comparison of models on a small sweep: its tables, and what `tolman compare` makes of them."""
import csv
import subprocess
import sys
import unittest

from support import ROOT, Systems, tolman as program

from tolman import models

WALK = """source: {{plugin: python, file: {trajectory}, side: 15, speed: 2, view_radius: 1, rooms: {rooms}, duration: {duration}}}
    record.arrays_every: 1"""


class CompareModelsTest(Systems):
    def setUp(self):
        super().setUp()
        self.config(odometry="{plugin: motion_replay}", place="{plugin: place_replay, relative_pose: true, view_step: 1000}")
        walks = {name: WALK.format(trajectory=models.path("trajectory"), rooms=rooms, duration=duration)
                 for name, rooms, duration in (("box", 1, 150), ("rooms", 2, 240))}
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
""")

    def test_its_tables_tell_hexagons_from_squares_and_who_relocates(self):
        swept = program("sweep", self.study, "--out", self.folder / "sweep")
        self.assertEqual(swept.returncode, 0, swept.stderr)
        done = subprocess.run([sys.executable, ROOT / "scripts/compare-models", self.folder / "sweep"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / "sweep/models-cells.csv", newline="") as file:
            rows = {(row["model"].split(",")[0], row["measure"]): float(row["value"]) for row in csv.DictReader(file)}
        self.assertGreater(rows["ssp", "Sargolini"], 0.8)
        self.assertLess(rows["bayesian_attractor", "Sargolini"], 0)
        self.assertGreater(rows["bayesian_attractor", "square"], 0.8)
        for model in ("ssp", "bayesian_attractor"):
            self.assertLess(abs(rows[model, "other room"]), 0.3)
        self.assertGreater(rows["bayesian_attractor", "right links"], 0)
        self.assertLess(rows["bayesian_attractor", "relocated after, s"], 80)
        self.assertEqual(rows["ssp", "right links"], 0)  # it has one hypothesis, and that is elsewhere
        self.assertNotIn(("ssp", "relocated after, s"), rows)
        self.assertIn("<svg", (self.folder / "sweep/models.svg").read_text())

        table = program("compare", self.folder / "sweep/models-cells.csv", "--by", "model", "--columns", "measure", "--only", "table=grid",
                        "--cell", "{value:.2f} ({chance:.2f})")
        self.assertEqual(table.returncode, 0, table.stderr)
        self.assertIn("| Sargolini | Langston | square |", table.stdout)
        metres = program("compare", self.folder / "sweep/models.csv", "--by", "model", "--columns", "sequence", "--cell", "{loops.true_links:.0f}")
        self.assertEqual(metres.returncode, 0, metres.stderr)


if __name__ == "__main__":
    unittest.main()
