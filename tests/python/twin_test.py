# SPDX-License-Identifier: BSD-3-Clause
"""One small model in C++ (tests/fixtures/plugins/path_cells.cpp) and in Python: the same bytes. And what a call costs more."""
import math
import sqlite3
import unittest

from support import BUILD, Systems, tolman as program

import numpy as np

import tolman

TWIN = '''
    import math
    import tolman

    UNITS = 8


    class PathCells(tolman.Cells):
        """Dead reckoning, for tests."""
        spacing: float = tolman.parameter(2, range=(0.1, 100), unit="m", doc="Between experiences.")
        period: float = tolman.parameter(6, range=(0.1, 100), unit="m", doc="Of the cells.")

        def start(self):
            self.pose, self.here, self.experiences, self.current, self.views = (0, 0, 0), (0, 0, 0), 0, -1, {}

        def step(self, motion, place):
            moved = tolman.to_planar(motion.T_previous_current)
            self.pose, self.here = tolman.compose(self.pose, moved), tolman.compose(self.here, moved)
            answer = tolman.Decision(template_id=place.template_id)
            view = self.views.get(place.template_id)
            if place.recognition == "familiar" and view is not None and view != self.current:
                self.current, self.here = view, tolman.to_planar(place.T_template_current)
                answer.action, answer.has_relative_pose = "close_loop", True
                answer.T_experience_current, answer.covariance = tolman.from_planar(*self.here), place.covariance
                answer.relative_yaw = self.here[2]
            elif self.current < 0 or math.sqrt(self.here[0] * self.here[0] + self.here[1] * self.here[1]) >= self.spacing:
                self.current, self.experiences, self.here = self.experiences, self.experiences + 1, (0, 0, 0)
                answer.action = "create_experience"
            else:
                answer.relative_yaw = self.here[2]
            if place.recognition == "novel":
                self.views[place.template_id] = self.current
            answer.experience = self.current
            answer.heading = self.pose[2] + 2 * math.pi if self.pose[2] < 0 else self.pose[2]
            answer.confidence = 1 / (1 + self.pose[0] * self.pose[0])
            return answer

        def arrays(self):
            return {"grid.activity": [1 + math.cos(2 * math.pi * (self.pose[0] / self.period - i / UNITS)) for i in range(UNITS)]}

        def describe(self):
            axis = tolman.ArrayAxis("x", "m", 0, self.period / UNITS, self.period)
            return [tolman.ArrayInfo("grid.activity", "activity", axes=[axis])]
'''


class TwinTest(Systems):
    def setUp(self):
        super().setUp()
        self.write("twin.py", TWIN)
        rng, edges, turns = np.random.default_rng(8), [], rng_turns()
        for i, turn in enumerate(turns):  # three rounds of a bent ring
            edges.append(f"EDGE_SE2 {i} {i + 1} {0.9 + 0.01 * rng.normal():.9f} {0.01 * rng.normal():.9f} {turn:.9f} 100 0 0 100 0 1000")
        (self.folder / "odometry.g2o").write_text("\n".join(edges) + "\n")
        loops = [f"EDGE_SE2 {i} {i - 40} {0.1 * rng.normal():.9f} 0.05 0.02 1 0 0 1 0 1" for i in range(45, 120, 5)]
        (self.folder / "loop_candidates.g2o").write_text("\n".join(loops) + "\n")

    def outcome(self, out, cells):
        noise = "{plugin: motion_replay, noise_distance: 0.05, noise_heading: 0.02}"
        ran = self.run_system("--plugin-path", BUILD / "tests/fixtures/plugins/path_cells", out=out, odometry=noise,
                              place="{plugin: place_replay, relative_pose: true}", cells=cells)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        database = sqlite3.connect(self.folder / out / "run.sqlite")
        tables = {name: database.execute(f'SELECT * FROM "{name}" ORDER BY 1').fetchall() for name in ("decision", "map_update", "link", "array", "array_info")}
        return (self.folder / out / "results.sha256").read_text(), tables

    def test_both_give_the_same_bytes(self):
        for options in ("", ", spacing: 3.3, period: 4.7"):
            with self.subTest(options=options):
                digest, tables = self.outcome("cpp" + str(len(options)), f"{{plugin: path_cells{options}}}")
                twin_digest, twin_tables = self.outcome("python" + str(len(options)), f"{{plugin: python, file: twin.py{options}}}")
                self.assertGreater(sum(row[3] == "close_loop" or "close_loop" in row for row in tables["decision"]), 5)
                for name, rows in tables.items():
                    self.assertEqual(rows, twin_tables[name], name)
                self.assertEqual(digest, twin_digest)


def rng_turns(count=120):
    """Turns of a ring of 40 steps with a wave on it, so that headings are of all kinds."""
    return [2 * math.pi / 40 + 0.1 * math.sin(0.7 * (i % 40)) for i in range(count)]


if __name__ == "__main__":
    unittest.main()
