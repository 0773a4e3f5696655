# SPDX-License-Identifier: BSD-3-Clause
"""Planar poses (x forward, y left, theta counter-clockwise; metres, radians) and 4x4 poses in camera axes."""
import math

import numpy as np


def to_planar(T):
    """(x, y, theta) of a 4x4 pose or motion."""
    return T[2, 3], -T[0, 3], math.atan2(-T[0, 2], T[2, 2])


def from_planar(x, y, theta):
    """The 4x4 pose without height, pitch and roll; to_planar inverts it."""
    c, s = math.cos(theta), math.sin(theta)
    return np.array([[c, 0, -s, -y], [0, 1, 0, 0], [s, 0, c, x], [0, 0, 0, 1.0]])


def compose(a, b):
    """a followed by b, where b is given in the coordinates of a."""
    c, s = math.cos(a[2]), math.sin(a[2])
    return a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], wrap_angle(a[2] + b[2])


def between(a, b):
    """The motion from a to b, in the coordinates of a: compose(a, between(a, b)) is b."""
    c, s = math.cos(a[2]), math.sin(a[2])
    x, y = b[0] - a[0], b[1] - a[1]
    return c * x + s * y, c * y - s * x, wrap_angle(b[2] - a[2])


def wrap_angle(angle):
    """In [-pi, pi), to the bit as tolman/geometry.hpp."""
    wrapped = angle - 2 * math.pi * math.floor((angle + math.pi) / (2 * math.pi))
    return wrapped if wrapped < math.pi else wrapped - 2 * math.pi  # floor can round up to pi


def set_planar_velocity(motion, dt):
    """Fills dt, v and omega of a Motion from its T_previous_current."""
    x, y, theta = to_planar(motion.T_previous_current)
    distance = float(np.hypot(x, y))  # that of the C library; math.hypot rounds in another way
    motion.dt = dt
    motion.v = (-distance if x < 0 else distance) / dt if dt > 0 else 0.0
    motion.omega = theta / dt if dt > 0 else 0.0
