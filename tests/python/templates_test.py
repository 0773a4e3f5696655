# SPDX-License-Identifier: BSD-3-Clause
"""What `tolman plugins new ROLE NAME --python` writes works at once and conforms at the strictest level."""
import json
import re
import unittest

from support import ROOT, Systems, tolman

STAGE_ROLES = ("source", "odometry", "place", "cells", "map", "observer")


class TemplatesTest(Systems):
    def made(self, role):
        written = tolman("plugins", "new", role, "mine", self.folder / role, "--python")
        self.assertEqual(written.returncode, 0, written.stderr)
        self.assertIn("tolman run mine.yaml".split()[-1], written.stdout)
        return self.folder / role

    def test_every_role_conforms(self):
        for role in STAGE_ROLES:
            with self.subTest(role=role):
                folder = self.made(role)
                found = tolman("plugins", "validate", folder / "mine.py", "--json", "--timeout", "300")
                report = json.loads(found.stdout)[0]
                faults = [finding for check in report["checks"] for finding in check["findings"]
                          if finding["severity"] != "note"]
                self.assertEqual(found.returncode, 0, faults)
                self.assertEqual(report["role"], role)
                self.assertGreaterEqual(len(report["checks"]), 15)

    def test_the_model_of_the_page_conforms(self):
        page = (ROOT / "docs/python.md").read_text()
        model = re.search(r"```python\n(import math.*?)```", page, re.DOTALL)[1]
        found = tolman("plugins", "validate", self.write("page.py", model), "--level", "2")
        self.assertEqual(found.returncode, 0, found.stdout)

    def test_written_systems_are_legal(self):
        for role in STAGE_ROLES:
            with self.subTest(role=role):
                checked = tolman("check", "mine.yaml", cwd=self.made(role))
                self.assertEqual(checked.returncode, 0, checked.stderr)

    def test_a_written_system_runs(self):
        folder = self.made("source")
        ran = tolman("run", "mine.yaml", "--set", "source.frames=6", "--out", "r", cwd=folder)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(json.loads((folder / "r/run.json").read_text())["counters"]["frames"], 6)


if __name__ == "__main__":
    unittest.main()
