# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps and comparisons from Python."""
import unittest

from support import Systems, write_octagon

import tolman


class SweepsTest(Systems):
    def setUp(self):
        super().setUp()
        self.data = self.folder / "data"  # apart from what the sweep writes
        self.data.mkdir()
        write_octagon(self.data)
        (self.data / "ground_truth.g2o").write_text((self.data / "odometry.g2o").read_text())

    def study(self):
        self.config(odometry="{plugin: motion_replay, noise_distance: 0.1, noise_heading: 0.02}")
        return self.write("study.yaml", f"""
            base: system.yaml
            list:
              model:
                bayes: {{cells.plugin: bayesian_attractor}}
                paper: {{cells.plugin: paper_attractor}}
            sequences: {{"07": {{source.path: {self.data}}}}}
            seeds: 3
        """)

    def test_a_sweep_is_made_tabled_and_compared(self):
        made = tolman.sweep(self.study(), out=self.folder / "sweep", jobs=1)
        self.assertEqual(sorted((factors["model"], factors["seed"]) for factors, _ in made.runs),
                         [(model, seed) for model in ("bayes", "paper") for seed in "123"])
        table = made.table("odometry.ate.rmse_m")
        self.assertEqual(list(table["seed"]), [1, 2, 3, 1, 2, 3])
        self.assertEqual(set(table["sequence"]), {"07"})
        for (factors, run), error in zip(made.runs, table["odometry.ate.rmse_m"]):
            self.assertIn(run.metrics["odometry"]["ate"]["rmse_m"], list(table["odometry.ate.rmse_m"]), factors)
            self.assertGreater(error, 0)
        file = self.folder / "study.yaml"  # a plan with fewer runs: the others stay in the folder, and count no more
        file.write_text(file.read_text().replace("seeds: 3", "seeds: 2"))
        self.assertEqual(len(tolman.sweep(file, out=self.folder / "sweep").runs), 4)
        file.write_text(file.read_text().replace("seeds: 2", "seeds: 3"))
        tolman.sweep(file, out=self.folder / "sweep")
        compared = tolman.compare(made, by="model", metric="odometry.ate.rmse_m", only={"sequence": "07"}, baseline="paper")
        self.assertEqual(list(compared["runs"]), [3, 3])
        mean = sum(table["odometry.ate.rmse_m"][:3]) / 3
        self.assertAlmostEqual(list(compared["mean"])[0], mean)
        self.assertLessEqual(list(compared["mean_low"])[0], mean)
        self.assertEqual(repr(tolman.Sweep(made.path)), repr(made))

    def test_runs_are_compared(self):
        config = self.config(source=f"{{plugin: motion_log, path: {self.data}}}", odometry="{plugin: motion_replay, noise_heading: 0.02}")
        runs = [tolman.run(config, set={"seed": 1, "cells.plugin": cells}, out=self.folder / cells) for cells in ("bayesian_attractor", "paper_attractor")]
        compared = tolman.compare(*runs, by="cells.plugin")
        self.assertEqual(len(compared["mean"]), 2)

    def test_runs_that_failed_are_told(self):
        made = tolman.sweep(self.study(), out=self.folder / "sweep")
        folder = next(entry for entry in sorted(made.path.iterdir()) if entry.name.startswith("model=paper"))
        outcome = folder / "outcome.json"
        outcome.write_text(outcome.read_text().replace('"done"', '"failed"'))
        with self.assertWarnsRegex(UserWarning, "1 runs failed or are not done"):
            self.assertEqual(len(made.runs), 5)
        with self.assertWarnsRegex(UserWarning, "of 6 runs 1 failed"):
            self.assertEqual(len(made.table("odometry.ate.rmse_m")), 5)
        with self.assertWarnsRegex(UserWarning, "of 6 runs 1 failed"):
            tolman.compare(made, by="model", metric="odometry.ate.rmse_m")
        others = [entry for entry in sorted(made.path.iterdir()) if entry.name.startswith("model=bayes")]
        (others[0] / "outcome.json").write_text("{")
        (others[1] / "point.json").write_text("[]")
        with self.assertWarnsRegex(UserWarning, "3 runs failed or are not done"):
            self.assertEqual(len(made.runs), 3)

    def test_failures_are_told(self):
        with self.assertRaises(FileNotFoundError):
            tolman.Sweep(self.folder)
        with self.assertRaises(tolman.RunFailed) as failed:
            tolman.sweep(self.write("study.yaml", "base: nowhere.yaml\nseeds: 2\n"), out=self.folder / "none")
        self.assertEqual(failed.exception.code, 3)
        with self.assertRaisesRegex(tolman.RunFailed, "colour"):
            tolman.compare(tolman.sweep(self.study(), out=self.folder / "sweep"), by="colour")


if __name__ == "__main__":
    unittest.main()
