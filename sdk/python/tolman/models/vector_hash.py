# SPDX-License-Identifier: BSD-3-Clause
"""Grid modules as the scaffold of an associative memory of views (Chandra et al., Nature 2025)."""
import numpy as np

import tolman
from tolman.navigation import Navigator


class VectorHash(Navigator):
    """Vector-HaSH: grid modules, random hippocampal layer, views bound to it by the pseudo-inverse (Chandra et al. 2025)."""

    periods: list[float] = tolman.parameter([3, 4, 5], range=(2, 11), doc="Whole numbers: periods of the modules, in states.")
    state_size: float = tolman.parameter(5, range=(1e-3, 1e6), unit="m", doc="Length of a state of the grid modules.")
    hippocampal: int = tolman.parameter(300, range=(10, 2000), unit="cells", doc="Cells of the hippocampal layer.")
    threshold: float = tolman.parameter(0.5, range=(0, 2), doc="Threshold of the hippocampal cells.")
    sensory: int = tolman.parameter(300, range=(10, 2000), unit="cells", doc="Length of the random pattern of a view.")

    def begin(self):
        if not self.periods or any(p != int(p) or not 2 <= p <= 11 for p in self.periods) or len(self.periods) > 6:
            raise tolman.InvalidParameter("periods are one to six whole numbers from 2 to 11")
        self.sides = [int(p) for p in self.periods]
        cells = sum(side**2 for side in self.sides)
        self.to_hippocampus = self.rng.standard_normal((self.hippocampal, cells))  # W_hg, fixed
        self.at = np.zeros(2)  # position in states
        self.stored = {}  # states of the modules by view
        self.patterns, self.hidden = [], []

    def grid(self, state):
        """One active cell a module: the state modulo its period."""
        parts = []
        for side in self.sides:
            part = np.zeros((side, side))
            part[int(state[0]) % side, int(state[1]) % side] = 1
            parts.append(part.ravel())
        return np.concatenate(parts)

    def hippocampus(self, grid):
        """h = [W_hg g - threshold]+."""
        return np.maximum(0, self.to_hippocampus @ grid - self.threshold)

    def grid_of(self, hidden):
        """g from h by the transposed weights and the strongest cell of each module, which is the clean state."""
        drive, parts, first = self.to_hippocampus.T @ hidden, [], 0
        for side in self.sides:
            part = np.zeros(side**2)
            part[np.argmax(drive[first:first + side**2])] = 1
            parts.append(part)
            first += side**2
        return np.concatenate(parts)

    def store(self, pattern, state):
        """Adds a view; W_sh = S H^+ and W_hs = H S^+ follow when they are asked for."""
        self.patterns.append(pattern)
        self.hidden.append(self.hippocampus(self.grid(state)))

    def recalled(self, pattern):
        """Grid state of a pattern (W_hs), and the pattern completed from there (W_sh)."""
        S, H = np.array(self.patterns).T, np.array(self.hidden).T
        grid = self.grid_of(np.maximum(0, H @ (np.linalg.pinv(S) @ pattern)))
        return grid, S @ (np.linalg.pinv(H) @ self.hippocampus(grid))

    def move(self, displacement):
        self.at = self.at + displacement / self.state_size

    def position(self):
        return self.at * self.state_size

    def learn(self, template):
        state = np.floor(self.at)
        self.stored[template] = self.at
        if len(self.patterns) < self.hippocampal:  # beyond, the memory only fades
            self.store(np.random.default_rng((self.seed, template)).choice([-1.0, 1.0], self.sensory), state)

    def recall(self, template, offset):
        self.at = 0.5 * self.at + 0.5 * (self.stored[template] + offset / self.state_size)

    def arrays(self):
        state, rates, first = np.floor(self.at), {}, 0
        grid = self.grid(state)
        for m, side in enumerate(self.sides):
            rates[_name(m)] = grid[first:first + side**2].reshape(side, side)
            first += side**2
        rates["hippocampus.activity"] = self.hippocampus(grid)[:64 if self.hippocampal > 64 else None]
        return rates

    def describe(self):
        infos = []
        for m, side in enumerate(self.sides):
            axes = [tolman.ArrayAxis(name, "m", 0, self.state_size, side * self.state_size) for name in ("x", "y")]
            infos.append(tolman.ArrayInfo(_name(m), "activity", "", "one active state of a module", axes=axes))
        return infos + [tolman.ArrayInfo("hippocampus.activity", "activity", "", "the first 64 cells of the layer",
                                         axes=[tolman.ArrayAxis("cell")])]


def _name(module):
    return f"grid{module + 1}.activity" if module else "grid.activity"
