# SPDX-License-Identifier: BSD-3-Clause
"""Place cells from boundary vector cells in a given rectangular room (Hartley et al. 2000)."""
import math

import numpy as np

import tolman
from tolman.navigation import Navigator

ANGLES = 120  # directions in which the distance of the walls is summed


class PlaceCells(Navigator):
    """Place cells that add up boundary vector cells of a rectangular room (Hartley et al. 2000)."""

    width: float = tolman.parameter(1.5, range=(0.1, 1e5), unit="m", doc="Room along the heading at the start, in its middle.")
    depth: float = tolman.parameter(1.5, range=(0.1, 1e5), unit="m", doc="Room to the left of it.")
    scale: float = tolman.parameter(1.0, range=(1e-3, 1e4), doc="Factor on all tuned distances; 1 for a rat.")
    cells: int = tolman.parameter(32, range=(1, 500), doc="Place cells.")
    inputs: int = tolman.parameter(4, range=(1, 16), doc="Boundary vector cells that each place cell adds up.")
    threshold: float = tolman.parameter(0.7, range=(0, 1), doc="As a share of the strongest summed input.")
    angular_width: float = tolman.parameter(0.2, range=(0.05, 2), unit="rad", doc="Sigma of the tuning to directions.")

    def begin(self):
        self.at = np.zeros(2)
        self.preferred = self.rng.uniform(0, 2 * math.pi, (self.cells, self.inputs))  # phi_i
        self.distance = self.scale * self.rng.uniform(0.05, 0.6, (self.cells, self.inputs))  # d_i, m
        box = np.stack(np.meshgrid(*(np.linspace(-0.48, 0.48, 15) * side for side in (self.width, self.depth))), axis=-1)
        self.strongest = np.max([self.drive(x) for x in box.reshape(-1, 2)], axis=0)

    def walls(self, x):
        """Distance of the wall in each direction, from a place in the room."""
        angle = np.arange(ANGLES) * 2 * math.pi / ANGLES
        direction = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        half = np.array([self.width, self.depth]) / 2
        inside = np.clip(x, -0.999 * half, 0.999 * half)
        with np.errstate(divide="ignore"):
            reach = np.where(direction > 0, half - inside, half + inside) / np.abs(direction)
        return angle, reach.min(axis=1)

    def drive(self, x):
        """Summed input of each place cell: Gaussians of distance and direction of the walls, equations 1 to 3."""
        angle, reach = self.walls(x)
        d = self.distance[..., None]
        width = 0.122 * self.scale * (d / (1.83 * self.scale) + 1)  # sigma_0 and beta of the paper, m
        off = (angle - self.preferred[..., None] + math.pi) % (2 * math.pi) - math.pi
        radial = np.exp(-((reach - d) ** 2) / (2 * width**2)) / np.sqrt(2 * math.pi * width**2)
        angular = np.exp(-(off**2) / (2 * self.angular_width**2)) / (math.sqrt(2 * math.pi) * self.angular_width)
        return (radial * angular).sum(axis=(1, 2)) * 2 * math.pi / ANGLES

    def rates(self, x):
        """F = [sum of inputs - T]+, as a share of the strongest sum in the room."""
        share = self.drive(x) / np.maximum(self.strongest, 1e-30)
        return np.clip(share - self.threshold, 0, 10)

    def move(self, displacement):
        self.at = self.at + displacement

    def position(self):
        return self.at

    def learn(self, template):
        pass

    def recall(self, template, offset):
        self.at = 0.5 * self.at + 0.5 * (np.array(self.views[template][:2]) + offset)

    def arrays(self):
        return {"place.activity": self.rates(self.at)}

    def describe(self):
        return [tolman.ArrayInfo("place.activity", "activity", "", "rates of the place cells", axes=[tolman.ArrayAxis("cell")])]
