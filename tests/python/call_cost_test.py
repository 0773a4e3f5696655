# SPDX-License-Identifier: BSD-3-Clause
"""The script that says what a call of a plugin in Python costs."""
import subprocess
import sys
import unittest

from support import ROOT, Systems


class CallCostTest(Systems):
    def test_it_measures_every_call_of_a_drive(self):
        done = subprocess.run([sys.executable, ROOT / "scripts/python-call-cost", self.folder, "--repeat", "2"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        *repeats, smallest = done.stdout.splitlines()
        self.assertEqual(len(repeats), 2)
        for line in repeats:
            words = line.split("  ")
            values = {word.rsplit(" ", 1)[0]: float(word.rsplit(" ", 1)[1]) for word in words}
            self.assertEqual(values["calls"], 25)  # the octagon's 24 motions and the first frame
            self.assertGreater(values["median"], 0)  # the way to the process and back
            self.assertLess(values["median"], values["99 %"])
            self.assertGreater(values["own"], 0)
        self.assertTrue(smallest.startswith("smallest, ms:  mean "), smallest)


if __name__ == "__main__":
    unittest.main()
