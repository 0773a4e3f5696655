# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program of the build tree on small systems that need no images."""
import os
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

try:
    import numpy  # noqa: F401
except ImportError:
    print("skipped: needs python3-numpy")
    sys.exit(77)

BUILD = pathlib.Path(os.environ["TOLMAN_BUILD"])
ROOT = pathlib.Path(__file__).resolve().parents[2]


def tolman(*arguments, cwd=None):
    """The finished process, with out and err as text."""
    return subprocess.run([BUILD / "bin/tolman", *map(str, arguments)], capture_output=True, text=True, cwd=cwd,
                          check=False, timeout=600)


def write_octagon(folder, frames=24):
    """A drive round an octagon of 3 m, and a loop candidate at its end."""
    turn = {True: 0.7853981633974483, False: 0}
    edges = [f"EDGE_SE2 {i} {i + 1} 1 0 {turn[i % 3 == 2]} 100 0 0 100 0 1000" for i in range(frames)]
    (folder / "odometry.g2o").write_text("\n".join(edges) + "\n")
    (folder / "loop_candidates.g2o").write_text(f"EDGE_SE2 {frames} 0 0 0 0 1 0 0 1 0 1\n")


class Systems(unittest.TestCase):
    """Cases with a folder, in which a system drives round an octagon."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="tolman-python-test-")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        write_octagon(self.folder)

    def write(self, name, text):
        (self.folder / name).write_text(textwrap.dedent(text))
        return self.folder / name

    def config(self, **stages):
        """The system of the octagon, with stages in other words."""
        chain = {"source": "{plugin: motion_log, path: .}", "odometry": "{plugin: motion_replay}",
                 "place": "{plugin: place_replay}", "cells": "{plugin: bayesian_attractor}",
                 "map": "{plugin: experience_map}", **stages}
        return self.write("system.yaml", "".join(f"{stage}: {text}\n" for stage, text in chain.items()))

    def run_system(self, *more, out="run", **stages):
        config = self.config(**stages)
        return tolman("run", config, "--out", self.folder / out, *more)
