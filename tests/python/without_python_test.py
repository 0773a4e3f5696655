# SPDX-License-Identifier: BSD-3-Clause
"""A build tree where pybind11 is missing: it is configured, and its plugin `python` says what is missing."""
import os
import shutil
import subprocess
import sys
import unittest

from support import BUILD, ROOT, Systems, tolman

CACHED = ("CMAKE_BUILD_TYPE", "CMAKE_GENERATOR", "CMAKE_CXX_COMPILER", "TOLMAN_MARCH_V3")


def cached():
    lines = [line.partition("=") for line in (BUILD / "CMakeCache.txt").read_text().splitlines()]
    return {name.partition(":")[0]: value for name, _, value in lines}


class WithoutPythonTest(Systems):
    def test_the_plugin_says_what_is_missing_and_other_cells_run(self):
        known, other = cached(), self.folder / "build"
        options = [f"-D{name}={known[name]}" for name in CACHED if name in known and name != "CMAKE_GENERATOR"]
        configured = subprocess.run(["cmake", "-S", ROOT, "-B", other, "-G", known["CMAKE_GENERATOR"], "-DTOLMAN_BUILD_TESTS=OFF",
                                     "-DCMAKE_DISABLE_FIND_PACKAGE_pybind11=ON", *options], capture_output=True, text=True, check=False)
        self.assertEqual(configured.returncode, 0, configured.stderr)
        self.assertIn("No plugins in Python: pybind11-dev or python3-dev is missing", configured.stdout)
        built = subprocess.run(["cmake", "--build", other, "--target", "tolman_program_python"], capture_output=True, text=True, check=False)
        self.assertEqual(built.returncode, 0, built.stdout[-2000:])

        plugins = self.folder / "plugins"
        plugins.mkdir()
        shutil.copy(other / "plugins/tolman_program_python.so", plugins)
        self.write("mine.py", "import tolman\n")
        refused = tolman("run", self.config(cells="{plugin: python, file: mine.py}"), "--plugin-path", plugins, "--out", self.folder / "run")
        self.assertEqual(refused.returncode, 4, refused.stderr)
        for words in ("this build of Tolman runs no Python", "pybind11-dev", "python3-dev"):
            self.assertIn(words, refused.stderr)
        ran = tolman("run", self.config(), "--plugin-path", plugins, "--quiet", "--out", self.folder / "run")
        self.assertEqual(ran.returncode, 0, ran.stderr)


if __name__ == "__main__":
    if not shutil.which("cmake") or os.environ.get("TOLMAN_BUILD") is None:
        print("skipped: needs cmake and a build tree")
        sys.exit(77)
    unittest.main()
