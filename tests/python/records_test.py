# SPDX-License-Identifier: BSD-3-Clause
"""Records in Python have the fields of the records in C++; planar poses are those of tolman/geometry.hpp."""
import dataclasses
import math
import re
import unittest

from support import ROOT

import numpy as np

import tolman
from tolman import records

HEADERS = ("camera", "fields", "records", "roles")
# A dict; no record in C++; cameras with lenses, which sources in Python do not have.
NOT_IN_PYTHON = {"named_array", "snapshot", "raw_camera", "raw_rig"}


def declared():
    """Names of the fields, by record, as the headers list them."""
    fields = {}
    for header in HEADERS:
        record = None
        for line in (ROOT / f"sdk/include/tolman/{header}.hpp").read_text().splitlines():
            if found := re.search(r'kRecord = "(\w+)"', line):
                record = found[1]
            if record and (found := re.match(r"\s*TOLMAN_FIELD\(([\w.]+),", line)):
                fields.setdefault(record, []).append(found[1].rpartition(".")[2])
    return fields


class RecordsTest(unittest.TestCase):
    def test_every_record_has_the_fields_of_its_declaration(self):
        found = declared()
        self.assertGreater(len(found), 15)
        for record, names in found.items():
            if record in NOT_IN_PYTHON:
                continue
            own = [field.name.rstrip("_") for field in dataclasses.fields(records.BY_NAME[record])]
            self.assertEqual(own, names, record)

    def test_a_misspelt_field_is_an_error(self):
        with self.assertRaises(AttributeError):
            tolman.Decision().experiance = 3

    def test_planar_poses(self):
        T = tolman.from_planar(2, 3, 0.5)
        self.assertTrue(np.allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3)))
        self.assertTrue(np.allclose(T[:3, 3], [-3, 0, 2]))  # camera axes: x right, z forward
        self.assertTrue(np.allclose(T[:3, 2], [-math.sin(0.5), 0, math.cos(0.5)]))
        self.assertTrue(np.allclose(tolman.to_planar(T), (2, 3, 0.5)))

    def test_composition_is_that_of_the_matrices(self):
        a, b = (1, 2, 0.7), (0.5, -1, 2.9)
        both = tolman.from_planar(*a) @ tolman.from_planar(*b)
        self.assertTrue(np.allclose(tolman.from_planar(*tolman.compose(a, b)), both))
        self.assertTrue(np.allclose(tolman.between(a, tolman.compose(a, b)), b))

    def test_velocity_is_negative_when_reversing(self):
        motion = tolman.Motion(T_previous_current=tolman.from_planar(-1, 0, 0.1))
        tolman.set_planar_velocity(motion, 0.5)
        self.assertAlmostEqual(motion.v, -2)
        self.assertAlmostEqual(motion.omega, 0.2)


if __name__ == "__main__":
    unittest.main()
