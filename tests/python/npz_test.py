# SPDX-License-Identifier: BSD-3-Clause
"""run.npz against run.sqlite, by NumPy alone."""
import errno
import io
import json
import os
import sqlite3
import subprocess
import sys
import unittest
import unittest.mock

from support import BUILD, Systems, tolman

import numpy as np

from tolman import npz
from tolman._files import exit_code_of
from tolman.results import Run


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

    def test_a_run_that_goes_on_is_exported_as_it_was_at_one_moment(self):
        self.assertEqual(self.run_system().returncode, 0)
        run_continues = sqlite3.connect(self.folder / "run/run.sqlite", isolation_level=None)
        run_continues.execute("PRAGMA journal_mode=WAL")  # as while the run goes on
        (self.folder / "run/run.json").write_text('{"status": "running"}')
        table = Run.table

        def table_before_a_change(run, name):
            read = table(run, name)
            run_continues.execute("UPDATE map_update SET experience = 99")
            return read

        with unittest.mock.patch.object(Run, "table", table_before_a_change):
            npz.write(self.folder / "run")
        file = np.load(self.folder / "run/run.npz")
        self.assertNotIn(99, file["map_update/experience"])
        self.assertEqual(set(Run(self.folder / "run").map["experience"]), {99})

    def test_without_scale_only_lengths_of_odometry_and_map_are_in_units(self):
        self.assertEqual(self.run_system().returncode, 0)
        with unittest.mock.patch.object(Run, "scale_known", False):
            units = json.loads(str(np.load(npz.write(self.folder / "run"))["units"]))
        self.assertEqual((units["trajectory/map/x"], units["trajectory/truth/x"]), ("units", "m"))

    def test_too_little_memory_is_told(self):
        def allocate():
            raise MemoryError

        self.assertEqual(exit_code_of(allocate), 70)
        self.assertEqual(self.run_system().returncode, 0)
        command = f"exec {BUILD / 'bin/tolman'} export {self.folder / 'run'} --npz"
        for kilobytes in range(130000, 60000, -10000):  # what is too little depends on the machine
            limited = subprocess.run(["bash", "-c", f"ulimit -v {kilobytes}; {command}"],
                                     capture_output=True, text=True, check=False, timeout=600)
            if limited.returncode != 0:
                break
        self.assertIn(limited.returncode, (8, 70), limited.stderr)
        self.assertIn("ulimit -v", limited.stderr)

    def test_too_few_open_files_are_told(self):
        def fail(error):
            def call():
                raise error
            return call

        self.assertEqual(self.run_system().returncode, 0)
        full = OSError(errno.EMFILE, os.strerror(errno.EMFILE), "table.py")
        library = ImportError(f"libx.so: cannot open shared object file: {os.strerror(errno.EMFILE)}")
        for error in (full, library):
            with unittest.mock.patch("sys.stderr", io.StringIO()) as told:
                self.assertEqual(exit_code_of(fail(error)), 8)
            self.assertIn("`ulimit -n`", told.getvalue())
        for kind in ("npz", "nwb"):
            for limit in (6, 7, 8):  # which is too low depends on the libraries
                done = subprocess.run(["bash", "-c", f"ulimit -n {limit}; exec {BUILD / 'bin/tolman'} export {self.folder / 'run'} --{kind}"],
                                      capture_output=True, text=True, check=False, timeout=600)
                if done.returncode != 0:
                    self.assertEqual(done.returncode, 8, done.stderr)
                    self.assertIn("ulimit -n", done.stderr)

    def test_nothing_is_written_into_another_run(self):
        for name in ("run", "other"):
            self.assertEqual(self.run_system(out=name).returncode, 0)
        run, other = self.folder / "run", self.folder / "other"
        for module in ("npz", "nwb"):
            for place, code in ((other / "x.file", 8), (other / "state/x.file", 8), (run / "x.file", 0), (self.folder / "x.file", 0)):
                done = subprocess.run([sys.executable, "-m", f"tolman.{module}", str(run), str(place), "--force"],
                                      capture_output=True, text=True, check=False, timeout=600)
                self.assertEqual(done.returncode, code, done.stderr)
                self.assertEqual(place.exists(), code == 0)
                if code:
                    self.assertIn(f"{place}: lies in the directory of the run {other.resolve()}, whose files belong to that run alone", done.stderr)

    def test_what_is_no_run_is_told(self):
        done = tolman("export", self.folder, "--npz")
        self.assertNotEqual(done.returncode, 0)


if __name__ == "__main__":
    unittest.main()
