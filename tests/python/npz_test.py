# SPDX-License-Identifier: BSD-3-Clause
"""run.npz against run.sqlite, by NumPy alone."""
import json
import sqlite3
import subprocess
import sys
import unittest

from support import Systems, tolman

import numpy as np


class NpzTest(Systems):
    def test_the_file_has_all_that_the_record_has(self):
        self.assertEqual(self.run_system().returncode, 0)
        done = tolman("export", self.folder / "run", "--npz", "--out", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        file = np.load(self.folder / "run.npz")  # refuses pickled objects
        units = json.loads(str(file["units"]))
        database = sqlite3.connect(self.folder / "run/run.sqlite")
        one = lambda query: [row[0] for row in database.execute(query)]
        self.assertEqual(file["link/from_experience"].tolist(), one('SELECT "from" FROM link ORDER BY id'))
        self.assertEqual(file["decision/action"].tolist(), one("SELECT action FROM decision ORDER BY frame"))
        self.assertEqual(file["frame/stamp_ns"].tolist(), one("SELECT stamp_ns FROM frame ORDER BY frame"))
        self.assertEqual(units["frame/stamp_ns"], "ns")
        heading = file["trajectory/map/heading"]
        self.assertEqual(heading.dtype, np.float64)  # a number, not a quaternion
        self.assertEqual(units["trajectory/map/heading"], "rad")
        forward = one("SELECT T_world_camera_z FROM final_pose ORDER BY frame")
        self.assertEqual(file["trajectory/map/x"].tolist(), forward)
        names = one("SELECT DISTINCT name FROM array")
        self.assertTrue(names)
        for name in names:
            rows = one(f"SELECT \"values\" FROM array WHERE name = '{name}' ORDER BY frame")
            together = np.frombuffer(b"".join(rows), np.float32)
            self.assertTrue(np.array_equal(file[f"array/{name}/values"].ravel(), together), name)
        maps = [name for name in file.files if name.startswith("rate_map/") and name.endswith("/values")]
        self.assertTrue(maps)
        for name in maps:
            edges = [len(file[name.replace("/values", f"/{axis}_edges")]) - 1 for axis in "xy"]
            self.assertEqual(list(file[name].shape[-2:]), edges)

    def test_exports_at_the_same_time_do_not_disturb_each_other(self):
        self.assertEqual(self.run_system().returncode, 0)
        write = [sys.executable, "-m", "tolman.npz", "--force", self.folder / "run", self.folder / "same.npz"]
        writers = [subprocess.Popen(write, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) for _ in range(4)]
        self.assertEqual([(writer.communicate()[1], writer.returncode) for writer in writers], [("", 0)] * 4)
        self.assertIn("frame/stamp_ns", np.load(self.folder / "same.npz").files)
        self.assertEqual(list(self.folder.glob("*.part")), [])

    def test_what_is_no_run_is_told(self):
        done = tolman("export", self.folder, "--npz")
        self.assertNotEqual(done.returncode, 0)


if __name__ == "__main__":
    unittest.main()
