# SPDX-License-Identifier: BSD-3-Clause
"""Spatial semantic pointers that integrate motion, on a hexagonal basis (Dumont et al. 2023)."""
import math

import numpy as np

import tolman
from tolman.navigation import Navigator


class Ssp(Navigator):
    """Spatial semantic pointers on a hexagonal basis, moved by oscillators (Dumont et al. 2023)."""

    spacing: float = tolman.parameter(60, range=(0.01, 1e6), unit="m", doc="Period of the finest grid module.")
    ratio: float = tolman.parameter(1.42, range=(1, 10), doc="Period of a module relative to the next finer one.")
    modules: int = tolman.parameter(4, range=(1, 12), doc="Number of periods.")
    orientations: int = tolman.parameter(3, range=(1, 12), doc="Directions of the waves of each module.")
    units: int = tolman.parameter(16, range=(4, 48), unit="cells", doc="Drawn along each axis of a module.")
    correction: float = tolman.parameter(0.5, range=(0, 1), doc="Weight of a view that agrees.")

    def begin(self):
        waves = []
        for m in range(self.modules):
            k = 4 * math.pi / (math.sqrt(3) * self.spacing * self.ratio**m)
            for r in range(self.orientations):  # three waves that sum to zero, for each direction
                angle = 2 * math.pi / 3 * np.arange(3) + r * math.pi / 3 / self.orientations
                waves.append(k * np.stack([np.cos(angle), np.sin(angle)], axis=1))
        self.phase_matrix = np.concatenate(waves)  # A
        self.spectrum = np.ones(len(self.phase_matrix), complex)  # of the pointer at the origin
        self.decoded = np.zeros(2)
        self.memory = {}

    def encode(self, x):
        """phi(x) in the Fourier domain: exp(i A x)."""
        return np.exp(1j * (self.phase_matrix @ x))

    def move(self, displacement):
        self.spectrum = self.spectrum * self.encode(displacement)
        self._clean(self.decoded + displacement)

    def _clean(self, near):
        """Oscillators go back to the length 1, and the position is read as the nearest one that fits all phases."""
        self.spectrum = self.spectrum / np.maximum(np.abs(self.spectrum), 1e-12)
        off = np.angle(self.spectrum * np.conj(self.encode(near)))
        self.decoded = near + np.linalg.lstsq(self.phase_matrix, off, rcond=None)[0]

    def position(self):
        return self.decoded

    def learn(self, template):
        self.memory[template] = self.spectrum

    def recall(self, template, offset):
        seen = self.memory[template] * self.encode(offset)  # bound with the offset
        there = self.decoded + np.linalg.lstsq(
            self.phase_matrix, np.angle(seen * np.conj(self.encode(self.decoded))), rcond=None)[0]
        near = (1 - self.correction) * self.decoded + self.correction * there
        self.spectrum = (1 - self.correction) * self.spectrum + self.correction * seen
        self._clean(near)

    def arrays(self):
        """Grid cells of each module: rectified sums of the three waves of its first direction."""
        rates = {}
        cells = np.stack(np.meshgrid(*2 * [np.arange(self.units) / self.units], indexing="ij"), axis=-1)
        for m in range(self.modules):
            period = self.spacing * self.ratio**m
            # A cell's own place: u and v of the period along lattice axes at 30 and 90 degrees.
            place = period * (cells[..., :1] * [math.sqrt(0.75), 0.5] + cells[..., 1:] * [0, 1])
            rows = slice(3 * self.orientations * m, 3 * self.orientations * m + 3)
            waves = np.exp(-1j * (place @ self.phase_matrix[rows].T)) @ self.spectrum[rows]
            rates[_name(m)] = np.maximum(0, waves.real / 3)
        return rates

    def describe(self):
        infos = []
        for m in range(self.modules):
            period = self.spacing * self.ratio**m
            axes = [tolman.ArrayAxis(name, "m", 0, period / self.units, period) for name in ("u", "v")]
            infos.append(tolman.ArrayInfo(_name(m), "activity", "", "three waves of one period", axes=axes))
        return infos


def _name(module):
    return f"grid{module + 1}.activity" if module else "grid.activity"
