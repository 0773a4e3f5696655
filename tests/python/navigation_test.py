# SPDX-License-Identifier: BSD-3-Clause
"""The shared decisions of the models in Python: a restart at an unknown pose, and the way back to a known place."""
import math
import unittest

import support  # skips without NumPy

import numpy as np

import tolman
from tolman.navigation import Navigator


class Point(Navigator):
    """A position as the code."""

    def begin(self):
        self.at = np.zeros(2)

    def move(self, displacement):
        self.at = self.at + displacement

    def position(self):
        return self.at

    def recall(self, template, offset):
        self.at = 0.5 * self.at + 0.5 * (np.array(self.views[template][:2]) + offset)


class RestartTest(unittest.TestCase):
    def setUp(self):
        self.cells = Point(agreement=1, experience_spacing=1, loop_minimum_travel=5, loop_spacing=1)
        for k in range(20):  # a straight way of 19 m with a view every metre
            self.step((1, 0, 0) if k else None, k, "novel")

    def step(self, moved, template=-1, recognition="none", seen=(0, 0, 0)):
        motion = tolman.Motion(state="initialising") if moved is None else tolman.Motion(state="tracking", T_previous_current=tolman.from_planar(*moved))
        place = tolman.PlaceObservation(recognition=recognition, template_id=template, has_relative_pose=template >= 0,
                                        T_template_current=tolman.from_planar(*seen), covariance=np.eye(6))
        return self.cells.step(motion, place)

    def test_a_restart_begins_an_experience_of_its_own(self):
        before = self.cells.experiences
        self.step((0.1, 0, 0))
        answer = self.step(None)
        self.assertEqual((answer.action, answer.experience), ("create_experience", before))

    def test_two_views_that_agree_tell_the_place(self):
        self.step(None)
        self.assertNotEqual(self.step((1, 0, 0), 4, "familiar", (0, 0.3, 1.2)).action, "close_loop")
        pose = tolman.compose((4, 0.3, 1.2), (0.9, 0, 0))
        answer = self.step((0.9, 0, 0), 5, "familiar", tolman.between((5, 0, 0), pose))
        self.assertEqual((answer.action, answer.experience), ("close_loop", 5))
        self.assertTrue(np.allclose(self.cells.position(), pose[:2]))
        self.assertAlmostEqual(answer.heading, pose[2])
        self.assertTrue(np.allclose(tolman.to_planar(answer.T_experience_current), tolman.between((5, 0, 0), pose)))

    def test_a_single_view_and_views_that_contradict_each_other_tell_nothing(self):
        self.step(None)
        at = self.cells.position()
        for template in (2, 9, 17, 5):
            self.assertNotEqual(self.step((0.2, 0, 0), template, "familiar").action, "close_loop")
        self.assertTrue(np.allclose(self.cells.position(), at + [0.8, 0]))

    def test_without_a_restart_far_views_are_refused_however_often_they_come(self):
        for template in (4, 5, 6, 7):
            self.assertNotEqual(self.step((1, 0, 0), template, "familiar").action, "close_loop")
        self.assertTrue(math.isclose(self.cells.position()[0], 23))


if __name__ == "__main__":
    unittest.main()
