# SPDX-License-Identifier: BSD-3-Clause
"""Plugins in Python in whole runs: parameters, arrays, state, provenance, seeds, and results that do not depend on threads."""
import json
import os
import shutil
import signal
import sqlite3
import subprocess
import time
import unittest
import unittest.mock

from support import BUILD, Systems, tolman, write_octagon

CELLS = '''
    import math
    import typing
    import numpy as np
    import tolman

    class Mine(tolman.Cells):
        """Random cells that count frames."""
        gain: float = tolman.parameter(2, range=(0, 10), unit="Hz", doc="Largest rate.")
        mode: typing.Literal["plain", "loud"] = tolman.parameter("plain", doc="How it talks.")

        def start(self):
            self.frames, self.activity = 0, np.zeros(6)

        def step(self, motion, place):
            assert motion.T_previous_current.shape == (4, 4) and motion.state in ("initialising", "tracking")
            assert place.recognition in ("none", "novel", "familiar")
            self.activity = self.gain * self.rng.random(6)
            self.frames += 1
            if self.mode == "loud" and self.frames == 3:
                self.log.warning("three frames")
            first = self.frames == 1
            return tolman.Decision(action="create_experience" if first else "stay", experience=0,
                                   heading=(0.1 * self.frames) % (2 * math.pi))

        def arrays(self):
            return {"hd.activity": self.activity}

        def describe(self):
            axis = tolman.ArrayAxis("heading", "rad", 0, math.pi / 3, 2 * math.pi)
            return [tolman.ArrayInfo("hd.activity", "activity", "Hz", "head direction cells", axes=[axis])]
'''
STAGE = "{plugin: python, file: mine.py%s}"

WALK = '''
    import numpy as np
    import tolman

    class Walk(tolman.Odometry):
        """A metre a frame, or a unit from a frame on."""
        metric_until: int = tolman.parameter(1000, range=(0, 1000), doc="Frame from which on the scale is unknown.")

        def start(self):
            self.last_ns = None

        def track(self, frame):
            motion = tolman.Motion()
            if self.last_ns is not None:
                motion.state, motion.tracked = "tracking", 50
                motion.T_previous_current = tolman.from_planar(1, 0, 0)
                motion.covariance = 1e-4 * np.eye(6)
                motion.scale_known = frame.frame < self.metric_until
                tolman.set_planar_velocity(motion, 1e-9 * (frame.stamp_ns - self.last_ns))
            self.last_ns = frame.stamp_ns
            return motion
'''
UNSCALED = "{plugin: python, file: walk.py, metric_until: %d}"


class ProgramsTest(Systems):
    def setUp(self):
        super().setUp()
        self.write("mine.py", CELLS)

    def rates(self, out):
        """The recorded bytes of all frames."""
        database = sqlite3.connect(self.folder / out / "run.sqlite")
        return database.execute('SELECT frame, "values" FROM array WHERE name = ? ORDER BY frame',
                                ("hd.activity",)).fetchall()

    def test_variables_for_other_programs_change_nothing(self):
        for name, value in {"PYTHONHOME": "/nowhere", "PYTHONOPTIMIZE": "2", "PYTHONINSPECT": "1", "PYTHONHASHSEED": "abc"}.items():
            with unittest.mock.patch.dict(os.environ, {name: value}):
                ran = self.run_system(cells=STAGE % "", out=name)
                self.assertEqual(ran.returncode, 0, ran.stderr)
                listed = tolman("plugins", "describe", self.folder / "mine.py")
                self.assertIn("Random cells that count frames.", listed.stdout)  # -OO removes texts
                exported = tolman("export", self.folder / name, "--npz")
                self.assertEqual(exported.returncode, 0, exported.stderr)
                self.assertIn("run.npz", exported.stdout)
                self.assertEqual(exported.stderr, "")

    def test_an_artefact_of_text_without_utf_8_is_a_failure(self):
        self.write("mine.py", CELLS.replace("self.frames += 1", "self.write_artefact('a.txt', 'x' + chr(0xd800))"))
        ran = self.run_system(cells=STAGE % "")
        self.assertEqual(ran.returncode, 7, ran.stderr)
        self.assertIn("surrogates not allowed", ran.stderr)

    def test_a_run_records_answers_arrays_and_origin(self):
        ran = self.run_system(cells=STAGE % ", gain: 3, mode: loud")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("three frames", ran.stderr)
        database = sqlite3.connect(self.folder / "run/run.sqlite")
        rows = database.execute("SELECT frame, action, experience, heading FROM decision ORDER BY frame").fetchall()
        self.assertEqual(len(rows), 25)
        self.assertEqual(rows[0][1:3], ("create_experience", 0))
        self.assertAlmostEqual(rows[9][3], 1.0)
        plugins = json.loads((self.folder / "run/run.json").read_text())["plugins"]
        cells = next(plugin for plugin in plugins if plugin["stage"] == "cells")
        self.assertEqual(cells["program"], str(self.folder / "mine.py"))
        self.assertEqual(len(cells["program_sha256"]), 64)

    def test_results_depend_on_the_seed_and_not_on_threads(self):
        for out, more in (("a", ("--threads", 1)), ("b", ("--threads", 4)), ("c", ("--seed", 7))):
            ran = self.run_system(*more, out=out, cells=STAGE % "")
            self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(len(self.rates("a")), 25)
        self.assertEqual(self.rates("a"), self.rates("b"))
        self.assertNotEqual(self.rates("a"), self.rates("c"))

    def test_a_sweep_freezes_what_each_program_is_made_of(self):
        self.write("gains.py", "DOUBLE = 2\n")
        self.write("other.py", CELLS.replace("import math", "import math\n    import gains", 1))
        (self.folder / "drive").mkdir()
        write_octagon(self.folder / "drive")
        self.config(source="{plugin: motion_log, path: drive}", cells=STAGE % "")
        study = self.write("study.yaml", """\
            base: system.yaml
            list: {model: {mine: {cells: {plugin: python, file: mine.py}}, other: {cells: {plugin: python, file: other.py}}}}
            """)

        def keys():
            ran = tolman("sweep", study, "--out", self.folder / "out")
            self.assertEqual(ran.returncode, 0, ran.stderr)
            points = [json.loads(file.read_text()) for file in (self.folder / "out").glob("*/point.json")]
            return {name: {point["key"] for point in points if point["name"] == f"model={name}"} for name in ("mine", "other")}

        first = keys()
        self.assertEqual([len(of) for of in first.values()], [1, 1])
        self.assertEqual(keys(), first)
        self.write("gains.py", "DOUBLE = 3\n")  # what the other one imports
        second = keys()
        self.assertEqual((second["mine"], len(second["other"])), (first["mine"], 2))
        self.write("mine.py", CELLS + "\n    # edited\n")
        third = keys()
        self.assertEqual((len(third["mine"]), third["other"]), (2, second["other"]))

        frozen = next(file.parent for file in (self.folder / "out").glob("*/point.json")
                      if json.loads(file.read_text())["name"] == "model=other")
        (frozen / "outcome.json").unlink()
        self.write("gains.py", "DOUBLE = 4\n")
        refused = tolman("sweep", "point", frozen)
        self.assertEqual(refused.returncode, 4, refused.stderr)
        self.assertIn("gains.py has changed since the run was planned", refused.stderr)

    def with_helper(self):
        """The modules that other.py imports: a helper, one of a package, and one of another folder."""
        for name in ("parts", "common"):
            (self.folder / name).mkdir()
        imports = ["import math", "import sys", "import gains", "from parts import inner",
                   f"sys.path.insert(0, {str(self.folder / 'common')!r})", "import shared"]
        self.write("other.py", CELLS.replace("import math", "\n    ".join(imports), 1))
        return self.write("gains.py", "DOUBLE = 2\n"), self.write("parts/inner.py", "HALF = 0.5\n"), self.write("common/shared.py", "ONE = 1\n")

    def test_a_run_whose_program_imports_other_modules_is_not_resumed(self):
        helpers = self.with_helper()
        (self.folder / "drive").mkdir()
        write_octagon(self.folder / "drive")
        config = self.config(source="{plugin: motion_log, path: drive}", cells="{plugin: python, file: other.py}")
        out = self.folder / "run"
        words = ["run", config, "--out", out, "--set", "record.state_every=0.05", "--set", "pipeline.mode=realtime",
                 "--set", "pipeline.input_policy=block"]
        going = subprocess.Popen([BUILD / "bin/tolman", *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + 60
        while not (out / "state/checkpoint.json").exists() and going.poll() is None and time.monotonic() < end:
            time.sleep(0.01)
        going.kill()
        self.assertEqual(going.wait(), -signal.SIGKILL)

        def contents():
            return {file: file.read_bytes() for file in out.rglob("*") if file.is_file() and "sqlite" not in file.name}

        before = contents()
        for helper in helpers:
            text = helper.read_text()
            helper.write_text(text + "# edited\n")
            refused = tolman("run", "--resume", out)
            self.assertEqual(refused.returncode, 9, refused.stderr)
            self.assertIn(f"{helper}: has other contents than when the run began ({out}/run.json); put it back", refused.stderr)
            self.assertEqual(contents(), before)
            helper.write_text(text)
        resumed = tolman("run", "--resume", out)
        self.assertEqual(resumed.returncode, 0, resumed.stderr)

    def test_a_session_that_continues_with_another_program_is_warned_of(self):
        helper, *_ = self.with_helper()
        monday, cells = self.folder / "monday", "{plugin: python, file: other.py}"
        self.assertEqual(self.run_system(out="monday", cells=cells).returncode, 0)
        same = self.run_system("--continue", monday, out="same", cells=cells)
        self.assertEqual(same.returncode, 0, same.stderr)
        self.assertNotIn("other contents", same.stderr)
        for edited, changed in ((helper, f"{helper} has"), (self.folder / "other.py", f"{helper}, {self.folder}/other.py have")):
            edited.write_text(edited.read_text() + "\n# edited\n")
            ran = self.run_system("--continue", monday, out="tuesday", cells=cells)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            self.assertEqual(ran.stderr.count(f"{changed} other contents than in the earlier session"), 1, ran.stderr)
            self.assertIn("other contents than in the earlier session", (self.folder / "tuesday/log.txt").read_text())
            shutil.rmtree(self.folder / "tuesday")

    def test_a_sweep_tells_programs_that_cannot_be_opened(self):
        self.write("broken.py", "import nothing_of_this_name\n")
        self.config(cells=STAGE % "")
        study = self.write("study.yaml", "base: system.yaml\ngrid: {cells.file: [mine.py, broken.py, missing.py]}\n")
        ran = tolman("sweep", study, "--out", self.folder / "out")
        self.assertNotEqual(ran.returncode, 0)
        for words in ("nothing_of_this_name", "missing.py: there is no such file"):
            self.assertIn(words, ran.stderr)

    def test_wrong_configurations_are_refused_before_the_run(self):
        for words, expected in (("gian: 3", "gain"), ("gain: 11", "0 ... 10 Hz"), ("mode: silent", "plain"),
                                ("gain: fast", "number")):
            checked = tolman("check", self.config(cells=STAGE % (", " + words)))
            self.assertEqual(checked.returncode, 3, words)
            self.assertIn(expected, checked.stderr)
            self.assertIn("system.yaml:4", checked.stderr)

    def test_wrong_files_are_refused(self):
        for stage, expected in (("{plugin: python}", "'file' is missing"), ("{plugin: python, file: none.py}", "no such file"),
                                ("{plugin: python, file: system.yaml}", "runs '.yaml' files")):
            checked = tolman("check", self.config(cells=stage))
            self.assertIn(checked.returncode, (3, 4))
            self.assertIn(expected, checked.stderr)
        checked = tolman("check", self.config(place=STAGE % ""))
        self.assertIn("[plugin/wrong-role]", checked.stderr)

    def test_the_schema_is_described_as_that_of_other_plugins(self):
        described = json.loads(tolman("plugins", "describe", self.folder / "mine.py", "--json").stdout)
        self.assertEqual(described["role"], "cells")
        self.assertEqual(described["summary"], "Random cells that count frames.")
        gain = described["parameters"][0]
        self.assertEqual((gain["name"], gain["type"], gain["min"], gain["max"], gain["unit"]),
                         ("gain", "real", 0, 10, "Hz"))
        schema = json.loads(tolman("plugins", "describe", self.folder / "mine.py", "--json-schema").stdout)
        properties = schema["$defs"]["cells.python"]["properties"]
        self.assertEqual(properties["gain"]["maximum"], 10)
        self.assertEqual(properties["plugin"]["const"], "python")
        self.assertIn("file", properties)

    def test_two_programs_in_one_run(self):
        self.write("watch.py", '''
            import tolman

            class Watch(tolman.Observer):
                """Counts what it sees."""
                def start(self):
                    self.seen = []
                def observe(self, snapshot):
                    self.seen.append(snapshot.cells["hd.activity"].shape)
                def finish(self, graph):
                    self.write_artefact("seen.txt", f"{len(self.seen)} {self.seen[-1]} {len(graph.experiences)}")
        ''')
        ran = self.run_system(cells=STAGE % "", observers="[{plugin: python, name: watch, file: watch.py}]")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual((self.folder / "run/artefacts/watch/seen.txt").read_text(), "25 (6,) 1")

    def test_a_continued_session_goes_on_from_the_saved_state(self):
        self.assertEqual(self.run_system(out="monday", cells=STAGE % "").returncode, 0)
        ran = self.run_system("--continue", self.folder / "monday", out="tuesday", cells=STAGE % "")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        database = sqlite3.connect(self.folder / "tuesday/run.sqlite")
        heading, = database.execute("SELECT heading FROM decision ORDER BY frame DESC LIMIT 1").fetchone()
        self.assertAlmostEqual(heading, 5.0)  # 50 frames

    def test_a_map_in_metres_is_not_continued_in_arbitrary_units(self):
        self.write("walk.py", WALK)
        monday = self.folder / "monday"
        self.assertEqual(self.run_system(out="monday", cells=STAGE % "", odometry=UNSCALED % 1000).returncode, 0)
        ran = self.run_system("--continue", monday, out="tuesday", cells=STAGE % "", odometry=UNSCALED % 0)
        self.assertEqual(ran.returncode, 9, ran.stderr)
        self.assertIn("odometry gives lengths in arbitrary units (scale_known is false), and the map of the "
                      f"earlier session {monday} has lengths in metres", ran.stderr)
        run = json.loads((self.folder / "tuesday/run.json").read_text())
        self.assertEqual((run["status"], run["failure"]["kind"]), ("failed", "continuation"))
        self.assertIn(str(monday), run["message"])
        self.assertFalse((self.folder / "tuesday/state/session.json").exists())
        ran = self.run_system("--continue", monday, out="same", cells=STAGE % "", odometry=UNSCALED % 1000)
        self.assertEqual(ran.returncode, 0, ran.stderr)

    def test_a_single_camera_continues_its_own_kind(self):
        self.write("walk.py", WALK)
        for out, more in (("monday", []), ("tuesday", ["--continue", self.folder / "monday"])):
            ran = self.run_system(*more, out=out, cells=STAGE % "", odometry=UNSCALED % 0)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            self.assertNotIn("scale_known", ran.stderr)

    def test_a_scale_that_changes_within_a_run_is_warned_of(self):
        self.write("walk.py", WALK)
        ran = self.run_system(cells=STAGE % "", odometry=UNSCALED % 12)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("in arbitrary units (scale_known is false), those before in metres", ran.stderr)
        self.assertIn("in arbitrary units", (self.folder / "run/log.txt").read_text())
        metrics = json.loads((self.folder / "run/metrics.json").read_text())
        for path in ("odometry", "map"):
            self.assertIn("some tracked motions are in metres", metrics[path]["warning"])


if __name__ == "__main__":
    unittest.main()
