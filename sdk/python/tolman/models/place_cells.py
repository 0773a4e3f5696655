# SPDX-License-Identifier: BSD-3-Clause
"""Place cells from boundary vector cells (Hartley et al. 2000), in a given rectangular room or among what stereo measures."""
import math
import typing

import numpy as np

import tolman
from tolman import boundaries
from tolman.navigation import Navigator

ANGLES = 120  # directions in which the distance of the walls is summed
ANGLE = np.arange(ANGLES) * 2 * math.pi / ANGLES


class PlaceCells(Navigator):
    """Place cells that add up boundary vector cells, of a given room or of stereo depth (Hartley et al. 2000)."""

    walls: typing.Literal["room", "stereo"] = tolman.parameter("room", doc="Where distances come from: the given room, or the points of stereo odometry.")
    width: float = tolman.parameter(1.5, range=(0.1, 1e5), unit="m", doc="Room along the heading at the start, in its middle.")
    depth: float = tolman.parameter(1.5, range=(0.1, 1e5), unit="m", doc="Room to the left of it.")
    scale: float = tolman.parameter(1.0, range=(1e-3, 1e4), doc="Factor on all tuned distances; 1 for a rat.")
    cells: int = tolman.parameter(32, range=(1, 500), doc="Place cells.")
    inputs: int = tolman.parameter(4, range=(1, 16), doc="Boundary vector cells that each place cell adds up.")
    threshold: float = tolman.parameter(0.7, range=(0, 1), doc="As a share of the strongest summed input.")
    angular_width: float = tolman.parameter(0.2, range=(0.05, 2), unit="rad", doc="Sigma of the tuning to directions.")
    camera_height: float = tolman.parameter(1.65, range=(0.01, 100), unit="m", doc="Of the level camera above the ground; for stereo.")
    heights: list[float] = tolman.parameter([0.5, 3.0], range=(-100, 1000), unit="m", doc="Lowest and highest structure that counts; for stereo.")
    farthest: float = tolman.parameter(30, range=(0.1, 1000), unit="m", doc="Points beyond are left out; for stereo.")
    memory: float = tolman.parameter(30, range=(0.1, 1000), unit="m", doc="Points are kept for so much path; for stereo.")

    def begin(self):
        self.at, self.near = np.zeros(2), np.zeros((0, 3))
        self.preferred = self.rng.uniform(0, 2 * math.pi, (self.cells, self.inputs))  # phi_i
        self.distance = self.scale * self.rng.uniform(0.05, 0.6, (self.cells, self.inputs))  # d_i, m
        if self.walls == "room":
            box = np.stack(np.meshgrid(*(np.linspace(-0.48, 0.48, 15) * side for side in (self.width, self.depth))), axis=-1)
            self.strongest = np.max([self.drive(self.room(x)) for x in box.reshape(-1, 2)], axis=0)
            return
        if not self.rig.baseline > 0:
            raise tolman.Unsupported("walls: stereo needs two cameras; take walls: room")
        if len(self.heights) != 2 or self.heights[0] >= self.heights[1]:
            raise tolman.InvalidParameter("heights are two: the lowest and a larger one")
        self.strongest = self.meeting()

    def room(self, x):
        """Distance of the wall in each direction, from a place in the room."""
        direction = np.stack([np.cos(ANGLE), np.sin(ANGLE)], axis=1)
        half = np.array([self.width, self.depth]) / 2
        inside = np.clip(x, -0.999 * half, 0.999 * half)
        with np.errstate(divide="ignore"):
            reach = np.where(direction > 0, half - inside, half + inside) / np.abs(direction)
        return reach.min(axis=1)

    def inputs_of(self, reach):
        """The boundary vector cells of each place cell, for distances in each direction: equations 1 and 2."""
        d = self.distance[..., None]
        width = 0.122 * self.scale * (d / (1.83 * self.scale) + 1)  # sigma_0 and beta of the paper, m
        off = (ANGLE - self.preferred[..., None] + math.pi) % (2 * math.pi) - math.pi
        radial = np.exp(-((reach - d) ** 2) / (2 * width**2)) / np.sqrt(2 * math.pi * width**2)
        angular = np.exp(-(off**2) / (2 * self.angular_width**2)) / (math.sqrt(2 * math.pi) * self.angular_width)
        return (radial * angular).sum(axis=-1) * 2 * math.pi / ANGLES

    def drive(self, reach):
        """Their sum."""
        return self.inputs_of(reach).sum(axis=1)

    def meeting(self):
        """The sum if each input had a long straight wall at its distance, across its direction: needs no knowledge of the place."""
        off = ANGLE - self.preferred[..., None]
        with np.errstate(divide="ignore"):
            reach = np.where(np.cos(off) > 1e-6, self.distance[..., None] / np.maximum(np.cos(off), 1e-6), np.inf)
        return self.drive(reach)

    def rates(self, reach):
        """F = [sum of inputs - T]+, as a share of the strongest sum: equation 3."""
        share = self.drive(reach) / np.maximum(self.strongest, 1e-30)
        return np.clip(share - self.threshold, 0, 10)

    def step(self, motion, place):
        answer = super().step(motion, place)
        if self.walls == "stereo":
            self.look(motion)
        return answer

    def look(self, motion):
        """Takes the points of a new keyframe, and forgets those of long ago and of before a restart."""
        self.near = boundaries.moved(self.near, tolman.to_planar(motion.T_previous_current))
        self.near = self.near[self.near[:, 2] > (self.travel - self.memory if motion.state != "initialising" else math.inf)]
        if motion.points_frame == motion.frame and motion.scale_known:
            seen = boundaries.structure(motion.points, self.rig, self.camera_height, self.heights, self.farthest)
            self.near = np.concatenate([self.near, np.column_stack([seen, np.full(len(seen), self.travel)])])

    def reach(self):
        """Distance of the nearest boundary in each direction."""
        return self.room(self.at) if self.walls == "room" else boundaries.reaches(self.near, self.heading, ANGLES, 3)

    def move(self, displacement):
        self.at = self.at + displacement

    def position(self):
        return self.at

    def learn(self, template):
        pass

    def recall(self, template, offset):
        self.at = 0.5 * self.at + 0.5 * (np.array(self.views[template][:2]) + offset)

    def arrays(self):
        return {"place.activity": self.rates(self.reach())}

    def describe(self):
        return [tolman.ArrayInfo("place.activity", "activity", "", "rates of the place cells", axes=[tolman.ArrayAxis("cell")])]
