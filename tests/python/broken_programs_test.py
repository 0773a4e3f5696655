# SPDX-License-Identifier: BSD-3-Clause
"""Broken plugins in Python: each is told by its fault, where it stands, and harms nothing but its own process."""
import subprocess
import textwrap
import time
import unittest

from support import Systems, tolman

CLASS = '''import tolman
{imports}
class Mine(tolman.Cells):
    """Cells with a fault."""
    {members}
    def start(self):
        self.frames = 0
        {start}
    def step(self, motion, place):
        self.frames += 1
        answer = tolman.Decision(action="stay" if self.frames > 1 else "create_experience", experience=0)
        if motion.frame == 3:
            {step}
        return answer
    {methods}
'''

SOURCE = '''import numpy as np
import tolman
class Mine(tolman.Source):
    """A straight way, which is odd on request."""
    tells: bool = tolman.parameter(False, doc="of truth")
    gives: bool = tolman.parameter(False, doc="truth")
    jump: float = tolman.parameter(0, range=(0, 1e7), unit="s", doc="before frame 10")
    step: float = tolman.parameter(0.1, range=(1e-6, 1e5), unit="s", doc="between frames")
    def start(self):
        self.sent = 0
    def info(self):
        return tolman.SourceInfo("odd", frames=30, has_truth=self.tells)
    def next(self):
        if self.sent >= 30:
            return None
        k, self.sent = self.sent, self.sent + 1
        truth = np.eye(4)
        truth[2, 3] = 0.1 * k
        sensors = {"motion.planar": np.array([0.1 if k else 0.0, 0, 0]), "place.candidate": np.zeros((0, 4)),
                   "place.looked": np.zeros(1), "motion.drive": np.ones(1)}
        stamp = k * self.step + (self.jump if k >= 10 else 0)
        return tolman.Frame(k, round(stamp * 1e9), k, None, None, self.gives, truth, "", sensors)
'''


def program(imports="", members="", start="pass", step="pass", methods=""):
    def deeper(text, by):
        return textwrap.indent(textwrap.dedent(text), " " * by).strip()

    return CLASS.format(imports=textwrap.dedent(imports), members=deeper(members, 4), start=deeper(start, 8),
                        step=deeper(step, 12), methods=deeper(methods, 4))


# What is refused when the file is opened.
OPENING = {
    "import of nothing": (program(imports="import no_such_module"), "ModuleNotFoundError: No module named 'no_such_module'"),
    "import error in the middle": (program(imports="from math import nothing"), "cannot import name 'nothing'"),
    "syntax": ("class Mine(:\n", "SyntaxError"),
    "indentation": (program() + "\n   x = 1\n", "IndentationError"),
    "not UTF-8": (b"x = '\xff'\n" + program().encode(), "SyntaxError"),
    "a zero byte": (b"x = 1\n\0" + program().encode(), "has a zero byte in line 2, so it is damaged or no text; restore it"),
    "UTF-16": (program().encode("utf-16"), "is UTF-16; save it as UTF-8"),
    "UTF-16 without a mark": (program().encode("utf-16-le"), "is UTF-16; save it as UTF-8"),
    "UTF-16, the higher byte first": (program().encode("utf-16-be"), "is UTF-16; save it as UTF-8"),
    "UTF-32": (program().encode("utf-32"), "is UTF-32; save it as UTF-8"),
    "import of a file in UTF-16": (
        program(imports="""
            import pathlib
            pathlib.Path(__file__).with_name("wide.py").write_bytes("x = 1".encode("utf-16"))
            import wide"""), "ValueError: a file that is imported here is UTF-16 or damaged; save it as UTF-8 (mine.py:5"),
    "empty": ("", "this one has none"),
    "no class of a role": ("import tolman\nclass Mine:\n    pass\n", "this one has none"),
    "two classes": (program() + program().replace("Mine", "Other"), "Mine, Other"),
    "two roles": ("import tolman\nclass Mine(tolman.Cells, tolman.Map):\n    'x'\n", "several roles"),
    "no docstring": ("import tolman\nclass Mine(tolman.Cells):\n    pass\n", "no docstring"),
    "raises at import": (program(imports="raise RuntimeError('not today')"), "RuntimeError: not today (mine.py:2"),
    "exits at import": (program(imports="import sys\nsys.exit(4)"), "SystemExit: 4"),
    "ends the process at import": (program(imports="import os\nos._exit(4)"), "exited with code 4"),
    "kills itself at import": (program(imports="import os\nos.kill(os.getpid(), 9)"), "SIGKILL"),
    "hangs at import": (program(imports="while True:\n    pass"), "did not return within 6 s"),
    "sleeps at import": (program(imports="import time\ntime.sleep(1000)"), 'mine.py", line 3 in <module>'),
    "never ends in a library": (program(imports="import re\nre.match('(a+)+$', 'a' * 60 + 'b')"), 'mine.py", line 3 in <module>'),
    "aborts at import": (
        program(imports="import os\nos.abort()"),
        "mine.py: while it was imported: its process died of SIGABRT (Aborted)"),
    "recursion at import": (program(imports="def f():\n    f()\nf()"), "RecursionError"),
    "parameter without type": (program(members="gain = tolman.parameter(1)"), "has no type"),
    "parameter of a strange type": (program(members="gain: set = tolman.parameter(1)"), "legal types"),
    "default of another type": (program(members="gain: int = tolman.parameter('x')"), "is no integer"),
    "default out of range": (program(members="gain: int = tolman.parameter(7, range=(0, 1))"), "[plugin/bad-schema]"),
    "parameter of the host's name": (program(members="file: str = tolman.parameter('x')"), "reserved"),
    "NaN as range": (program(members="gain: float = tolman.parameter(1, range=(float('nan'), 1))"), "empty range"),
}
# What ends the run at frame 3 (the fourth), or when it starts.
RUNNING = {
    "raises in start": (program(start="raise ValueError('no start')"), "ValueError: no start (mine.py:"),
    "an unknown parameter is read": (program(start="self.gain"), "no attribute 'gain'"),
    "raises": (program(step="raise ValueError('bad luck')"), "cells (python), step, frame 3: ValueError: bad luck"),
    "raises without words": (program(step="raise ValueError"), "ValueError: no message"),
    "raises what cannot be shown": (
        program(imports="class Odd(Exception):\n    def __str__(self):\n        raise TypeError('no')", step="raise Odd()"),
        "step, frame 3: Odd: its __str__ fails, so it has no message"),
    "asserts": (program(step="assert False, 'never'"), "AssertionError: never"),
    "divides by zero": (program(step="1 / 0"), "ZeroDivisionError"),
    "recursion": (program(methods="def f(self):\n    self.f()", step="self.f()"), "RecursionError"),
    "returns nothing": (program(step="return None"), "step(): should be a tolman.Decision, not NoneType"),
    "returns another record": (program(step="return motion"), "should be a tolman.Decision, not Motion"),
    "unknown action": (program(step="answer.action = 'fly'"), "step().action: should be one of 'stay'"),
    "text for a number": (program(step="answer.heading = 'north'"), "step().heading: should be a number, not str"),
    "fraction for an integer": (program(step="answer.experience = 0.5"), "step().experience: should be an integer"),
    "an integer too large": (program(step="answer.experience = 2**70"), "an integer of 64 bits; this one needs more"),
    "raises half a character": (program(step="raise ValueError('a\\udc80b')"), "step, frame 3: ValueError: a\ufffdb (mine.py:13"),
    "complex numbers": (program(imports="import numpy", step="answer.covariance = 1j * numpy.eye(6)"),
                        "step().covariance: should be an array of real numbers"),
    "masked numbers": (
        program(imports="import numpy", step="answer.covariance = numpy.ma.masked_equal(numpy.eye(6), 1)"),
        "step().covariance: should be an array without masked values"),
    "wrong shape": (program(imports="import numpy", step="answer.covariance = numpy.zeros((3, 3))"),
                    "step().covariance: should be an array of shape (6, 6), not ndarray of shape (3, 3)"),
    "array of objects": (program(step="answer.covariance = [[object()] * 6] * 6"), "step().covariance"),
    "NaN": (program(step="answer.heading = float('nan')"), "heading"),
    "infinite": (program(imports="import numpy", step="answer.covariance = numpy.full((6, 6), numpy.inf)"), "covariance"),
    "no rotation": (program(imports="import numpy", step="""
        answer.action, answer.has_relative_pose = 'close_loop', True
        answer.covariance = numpy.eye(6)
        answer.T_experience_current = numpy.zeros((4, 4))"""), "T_experience_current"),
    "another frame": (program(step="answer.frame = 77"), "frame"),
    "an experience that is not there": (program(step="answer.experience = 5"), "experience"),
    "a list of other things": (program(step="answer.earlier = [1]"), "step().earlier[0]: should be a tolman.EarlierLoop"),
    "no list": (program(step="answer.earlier = 3"), "step().earlier: should be a list"),
    "arrays are no dict": (program(methods="def arrays(self):\n    return [1, 2]"), "arrays(): should be a dict"),
    "arrays of text": (program(methods="def arrays(self):\n    return {'a': 'b'}"), "an array of numbers"),
    "arrays that grow": (program(methods="def arrays(self):\n    return {'a': [0] * (self.frames + 1)}"), "arrays"),
    "NaN in arrays": (program(methods="def arrays(self):\n    return {'a': [float('nan')]}"), "arrays"),
    "descriptions are wrong": (program(methods="def describe(self):\n    return [3]"), "describe()[0]"),
    "the class is changed": (program(step="del Mine.step"), "step"),
    "a record's class is changed": (program(step="tolman.Decision.__init__ = None\ntolman.Decision()"), "TypeError"),
    "sys.exit": (program(imports="import sys", step="sys.exit(3)"), "SystemExit: 3"),
    "os._exit": (program(imports="import os", step="os._exit(3)"), "exited with code 3"),
    "abort": (program(imports="import os", step="os.abort()"), "SIGABRT"),
    "segmentation fault": (program(imports="import ctypes", step="ctypes.string_at(0)"), "SIGSEGV"),
    "kills itself": (program(imports="import os", step="os.kill(os.getpid(), 9)"), "SIGKILL"),
    "endless loop": (program(step="while True: pass"), 'mine.py", line 13 in step'),
    "sleeps": (program(imports="import time", step="time.sleep(1000)"), "did not"),
    "waits for a lock": (program(imports="import threading", step="threading.Lock().acquire() or 0\nlock = threading.Lock()\n"
                                 "lock.acquire()\nlock.acquire()"), "did not"),
    "takes all memory": (program(step="answer.earlier = [bytearray(2**20) for i in range(10**6)]"), "memory"),
    "one huge array": (program(imports="import numpy", step="numpy.ones(2**34)"), "memory"),
    "closes all files": (program(imports="import os", step="os.closerange(0, 256)"), "cells (python)"),
}
# What is strange and harms nothing.
HARMLESS = {
    "fork": program(imports="import os", step="os.fork()"),
    "multiprocessing": program(imports="import multiprocessing", step="""
        other = multiprocessing.Process(target=print)
        other.start()
        other.join()"""),
    "threads that run on": program(imports="import threading, time", start="""
        threading.Thread(target=lambda: time.sleep(1000)).start()
        threading.Thread(target=lambda: time.sleep(1000), daemon=True).start()"""),
    "another working directory": program(imports="import os", step="os.chdir('/')"),
    "printing": program(step="print('x' * 100000)"),
    "closed output": program(imports="import sys", step="sys.stdout.close()\nsys.stderr.close()"),
    "ignored signals": program(imports="import signal", start="signal.signal(signal.SIGTERM, signal.SIG_IGN)"),
    "written to its inputs": program(step="motion.T_previous_current[:] = 7\nplace.template_id = 99"),
    "global random numbers": program(imports="import random, numpy", step="random.seed()\nnumpy.random.seed(None)"),
    "a changed module": program(imports="import json", step="json.dumps = None"),
    "no collector of garbage": program(imports="import gc", step="gc.disable()"),
    "a deeper stack": program(imports="import sys", step="sys.setrecursionlimit(100000)"),
}
HANGS = ("did not", 'mine.py", line')  # parts of what is expected of those that never answer


def limits(expected=""):
    """A deadline that only those reach that never answer, however slow the machine is."""
    return ("--set", f"isolation.deadline={6 if any(part in expected for part in HANGS) else 60}", "--set", "isolation.memory_limit=700")


STAGE = "{plugin: python, file: mine.py%s}"


class BrokenProgramsTest(Systems):
    def place(self, text):
        (self.folder / "mine.py").write_bytes(text if isinstance(text, bytes) else text.encode())

    def test_faults_of_opening_are_refusals(self):
        for name, (text, expected) in OPENING.items():
            with self.subTest(fault=name):
                self.place(text)
                checked = tolman("check", self.config(cells=STAGE % ""), *limits(expected))
                self.assertEqual(checked.returncode, 4, checked.stderr)
                self.assertIn(expected, checked.stderr)

    def test_faults_of_a_run_end_it_as_the_plugin_s(self):
        for name, (text, expected) in RUNNING.items():
            with self.subTest(fault=name):
                self.place(text)
                ran = self.run_system("--force", *limits(expected), cells=STAGE % "")
                self.assertIn(ran.returncode, (4, 7), ran.stderr)
                self.assertIn(expected, ran.stderr)

    def test_what_is_harmless_changes_no_result(self):
        self.place(program())
        self.assertEqual(self.run_system(out="plain", cells=STAGE % "").returncode, 0)
        for name, text in HARMLESS.items():
            with self.subTest(fault=name):
                self.place(text)
                ran = self.run_system("--force", *limits(), cells=STAGE % "")
                self.assertEqual(ran.returncode, 0, ran.stderr)
                self.assertEqual((self.folder / "run/results.sha256").read_text(),
                                 (self.folder / "plain/results.sha256").read_text())

    def test_a_traceback_names_frame_call_and_lines(self):
        self.place(program(methods="def deep(self):\n    raise ValueError('bad luck')", step="self.deep()"))
        ran = self.run_system(cells=STAGE % "")
        log = (self.folder / "run/log.txt").read_text()
        self.assertIn("in deep", log)
        self.assertIn("self.deep()", log)
        self.assertIn("step, frame 3", ran.stderr)

    def test_failures_are_skipped_where_the_run_says_so(self):
        self.place(program(step="raise ValueError('bad luck')"))
        ran = self.run_system(cells=STAGE % ", on_failure: skip")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("1 skipped", ran.stdout)

    def test_a_dead_process_is_restarted_where_the_run_says_so(self):
        self.place(program(imports="import os", step="os._exit(3)"))
        ran = self.run_system(cells=STAGE % ", on_failure: restart, isolation: process")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("1 skipped", ran.stdout)

    def test_nothing_runs_on(self):
        mark = "tolman_nothing_runs_on"
        self.place(program(imports="import os, sys, subprocess", start=f"""
            subprocess.Popen([sys.executable or '/usr/bin/python3', '-c', 'import time; time.sleep(600)', '{mark}'])"""))
        self.assertEqual(self.run_system(cells=STAGE % "").returncode, 0)
        time.sleep(0.5)
        listed = subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True, check=True).stdout
        self.assertFalse([line for line in listed.splitlines() if mark in line and "sleep" in line])

    def test_sources_that_say_one_thing_and_give_another_are_told(self):
        self.place(SOURCE)
        source = "{plugin: python, file: mine.py, %s}"
        refused = self.run_system(source=source % "gives: true")
        self.assertEqual(refused.returncode, 5, refused.stderr)
        self.assertIn("source (python), next, frame 0: gave a true pose, but info() says that there are none", refused.stderr)
        for setting, expected in {"jump: 500000": "frames are 1.724e+04 s apart (mean)",
                                  "step: 100": "frames are 100 s apart (mean)"}.items():
            with self.subTest(setting=setting):
                ran = self.run_system("--force", source=source % setting)
                self.assertEqual(ran.returncode, 0, ran.stderr)
                self.assertIn(expected, (self.folder / "run/log.txt").read_text())
        self.assertEqual(self.run_system("--force", source=source % "tells: true, gives: true").returncode, 0)
        self.assertEqual((self.folder / "run/log.txt").read_text(), "")


if __name__ == "__main__":
    unittest.main()
