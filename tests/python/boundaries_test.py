# SPDX-License-Identifier: BSD-3-Clause
"""Place cells on boundaries that stereo measures: a room of points against the same room as given."""
import math
import unittest

import support  # skips without NumPy

import numpy as np

import tolman
from tolman import _host, boundaries, models

RIG = tolman.CameraRig(width=640, height=480, calibrated=True, fx=300.0, fy=300.0, cx=320.0, cy=240.0, baseline=0.5)
HEIGHT = 1.65


def wall_points(half, low, high, count=20000, seed=4):
    """Forward, left, up of random points on the four walls of a square room."""
    rng = np.random.default_rng(seed)
    along, side, up = rng.uniform(-half, half, count), rng.integers(0, 4, count), rng.uniform(low, high, count)
    wall = np.where(side % 2 == 0, half, -half)
    swap = side < 2
    return np.column_stack([np.where(swap, wall, along), np.where(swap, along, wall), up])


def seen(world, pose):
    """The columns of Motion.points for points of the world, by a level camera at a planar pose."""
    c, s = math.cos(pose[2]), math.sin(pose[2])
    dx, dy = world[:, 0] - pose[0], world[:, 1] - pose[1]
    forward, left = c * dx + s * dy, c * dy - s * dx
    u, v = RIG.cx - RIG.fx * left / np.maximum(forward, 1e-9), RIG.cy + RIG.fy * (HEIGHT - world[:, 2]) / np.maximum(forward, 1e-9)
    visible = (forward > 0.5) & (u >= 0) & (u < RIG.width) & (v >= 0) & (v < RIG.height)
    return np.stack([u, v, 1 / np.maximum(forward, 1e-9), np.full(len(u), 1e-8)])[:, visible].astype(np.float32)


class BoundariesTest(unittest.TestCase):
    def test_only_sharp_points_above_the_ground_and_below_the_roofs_count(self):
        world = np.array([[10.0, 1, 1.0], [10, 2, 0.0], [10, 3, 9.0], [10, -1, 2.0], [40, 0, 1.0]])
        points = seen(world, (0, 0, 0))
        points[3, 3] = 0.02**2  # 20 % of the inverse depth
        found = boundaries.structure(points, RIG, HEIGHT, (0.5, 3), 30)
        self.assertTrue(np.allclose(found, [[10, 1]], atol=1e-3), found)

    def test_points_stay_where_they_are_while_the_animal_moves(self):
        world, pose, rng = np.array([3.0, 2.0]), (0.0, 0.0, 0.0), np.random.default_rng(2)
        kept = np.array([[3.0, 2.0, 7.0]])
        for step in rng.normal(0, 0.3, (50, 3)):
            kept, pose = boundaries.moved(kept, step), tolman.compose(pose, step)
        back = tolman.compose(pose, (*kept[0, :2], 0))
        self.assertTrue(np.allclose(back[:2], world))
        self.assertEqual(kept[0, 2], 7)

    def test_a_reach_needs_support_and_turns_with_the_heading(self):
        points = np.array([[5.0, 0, 0], [6, 0, 0], [7, 0, 0], [0, 4, 0]])
        reach = boundaries.reaches(points, math.pi / 2, 4, 2)
        self.assertEqual(list(reach), [math.inf, 6, math.inf, math.inf])


class StereoPlaceCellsTest(unittest.TestCase):
    def setUp(self):
        self.model = _host.open_program(str(models.path("place_cells")))["class"]

    def drive(self, cells, pose, motion, world):
        """One frame, at which odometry has made a keyframe."""
        motion.frame = motion.points_frame = motion.frame + 1
        motion.points = seen(world, pose)
        return cells.step(motion, tolman.PlaceObservation())

    def test_rates_are_those_of_the_room_that_the_camera_has_seen_round_it(self):
        world = wall_points(7.5, 0, 4)
        own = dict(width=15, depth=15, scale=10, seed=3)
        given, stereo = self.model(**own), self.model(walls="stereo", threshold=0.2, rig=RIG, **own)
        pose, turn = (0.0, 0.0, 0.0), (0.0, 0.0, 2 * math.pi / 20)
        path = [turn] * 20 + [(0.5, 0.0, 0.0)] * 8 + [turn] * 7 + [(0.4, 0.0, 0.0)] * 6
        first = tolman.Motion(frame=-1)
        self.drive(stereo, pose, first, world)
        for k, step in enumerate(path):
            pose = tolman.compose(pose, step)
            motion = tolman.Motion(frame=k, state="tracking", T_previous_current=tolman.from_planar(*step))
            self.drive(stereo, pose, motion, world)
        measured, true = stereo.reach(), given.room(np.array(pose[:2]))
        self.assertTrue(np.isfinite(measured).all())
        self.assertLess(np.median(np.abs(measured / true - 1)), 0.03)
        self.assertGreater(np.corrcoef(stereo.drive(measured), given.drive(true))[0, 1], 0.98)

    def test_a_restart_forgets_what_was_near(self):
        stereo = self.model(walls="stereo", rig=RIG)
        self.drive(stereo, (0, 0, 0), tolman.Motion(frame=-1, state="tracking"), wall_points(7.5, 0, 4))
        self.assertGreater(len(stereo.near), 100)
        stereo.step(tolman.Motion(frame=5, state="initialising"), tolman.PlaceObservation())
        self.assertEqual(len(stereo.near), 0)

    def test_one_camera_and_heights_that_are_no_range_are_refused(self):
        with self.assertRaises(tolman.Unsupported):
            self.model(walls="stereo")
        with self.assertRaises(tolman.InvalidParameter):
            self.model(walls="stereo", rig=RIG, heights=[3.0, 1.0])


if __name__ == "__main__":
    unittest.main()
