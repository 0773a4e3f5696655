# SPDX-License-Identifier: BSD-3-Clause
"""Boundaries from stereo: the points that odometry measures, kept round the animal, and the nearest ones in each direction.

Points are rows of forward and left (m, from the animal along its heading) and the path (m) at which they were measured.
"""
import math

import numpy as np

from tolman.geometry import between

LARGEST_ERROR = 0.1  # standard deviation of a distance, as a share of it


def structure(points, rig, camera_height, heights, farthest):
    """Forward and left of the points of a Motion that stand on the ground, in front of a level camera.

    `heights`: lowest and highest, m above the ground, which is `camera_height` below the camera.
    """
    u, v, inverse, variance = np.asarray(points, float)
    good = (inverse > 1 / farthest) & (np.sqrt(np.maximum(variance, 0)) < LARGEST_ERROR * inverse)
    u, v, depth = u[good], v[good], 1 / inverse[good]
    up = camera_height - (v - rig.cy) / rig.fy * depth
    stands = (up > heights[0]) & (up < heights[1])
    return np.stack([depth, -(u - rig.cx) / rig.fx * depth], axis=1)[stands]


def moved(points, step):
    """The same points after a planar step of the animal."""
    x, y, turn = between(step, (0, 0, 0))
    c, s = math.cos(turn), math.sin(turn)
    return np.column_stack([c * points[:, 0] - s * points[:, 1] + x, s * points[:, 0] + c * points[:, 1] + y, points[:, 2]])


def reaches(points, heading, directions, support):
    """Distance of the nearest structure in each of `directions` equal sectors, the first one centred at heading 0.

    That of the `support`-th nearest point, so that single wrong points are no walls; infinite where there are fewer.
    """
    angle = np.arctan2(points[:, 1], points[:, 0]) + heading
    sector = np.round(angle * directions / (2 * math.pi)).astype(int) % directions
    distance = np.hypot(points[:, 0], points[:, 1])
    order = np.lexsort((distance, sector))
    first = np.searchsorted(sector[order], np.arange(directions + 1))
    reach = np.full(directions, np.inf)
    enough = np.diff(first) >= support
    reach[enough] = distance[order][first[:-1][enough] + support - 1]
    return reach
