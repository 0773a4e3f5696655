# SPDX-License-Identifier: BSD-3-Clause
"""Measures of units against maps whose values are known, and against metrics.json of a run."""
import math
import unittest

from support import Systems, tolman as program

import numpy as np

import tolman
from tolman import models, spatial


def lattice(angle, side=40, spacing=10.0, direction=0.2):
    """A rate map of Gaussian fields on a lattice whose axes are `angle` apart."""
    basis = spacing * np.array([[math.cos(direction), math.sin(direction)],
                                [math.cos(direction + angle), math.sin(direction + angle)]])
    at = np.stack(np.meshgrid(*2 * [np.arange(side) + 0.5], indexing="ij"), axis=-1)
    corners = np.stack(np.meshgrid(*2 * [np.arange(-12, 13)], indexing="ij"), axis=-1).reshape(-1, 2) @ basis
    away = ((at[:, :, None] - corners) ** 2).sum(axis=-1)
    return np.exp(-away / (2 * (0.11 * spacing) ** 2)).sum(axis=-1)


class SpatialTest(unittest.TestCase):
    def test_the_autocorrelogram_is_that_of_a_sum_over_pairs(self):
        rng = np.random.default_rng(4)
        rates = rng.random((12, 9))
        rates[rng.random(rates.shape) < 0.2] = np.nan
        r = spatial.autocorrelogram(rates)
        for di, dj in ((0, 0), (2, 1), (-3, 2), (5, -1)):
            pairs = [(rates[i, j], rates[i - di, j - dj]) for i in range(12) for j in range(9)
                     if 0 <= i - di < 12 and 0 <= j - dj < 9]
            pairs = np.array([pair for pair in pairs if np.isfinite(pair).all()])
            self.assertAlmostEqual(r[11 + di, 8 + dj], np.corrcoef(pairs.T)[0, 1], places=9)
        self.assertTrue(np.isnan(r[0, 0]))

    def test_lattices_have_their_scores_and_spacings(self):
        hexagonal, square = (spatial.grid_scores(lattice(math.radians(angle))) for angle in (60, 90))
        self.assertGreater(hexagonal.sargolini, 1)
        self.assertGreaterEqual(hexagonal.langston, hexagonal.sargolini)
        self.assertLess(hexagonal.square, 0)
        self.assertGreater(square.square, 1)
        self.assertLess(square.sargolini, 0)
        self.assertAlmostEqual(hexagonal.spacing, 10, delta=0.4)
        self.assertAlmostEqual(square.spacing, 10, delta=0.4)

    def test_by_the_definition_a_square_lattice_is_far_below_zero_in_every_ring(self):
        """min(r60, r120) - max(r30, r90, r150): r90 of squares is 1, and r60 cannot be. The lattice of peaks of an autocorrelogram is a formula here."""
        def scores(inner, outer, angle):
            radius = np.linspace(inner, outer, 40)[:, None]
            basis = [(math.cos(a), math.sin(a)) for a in (0, math.radians(angle))]
            peaks = [(i * basis[0][0] + j * basis[1][0], i * basis[0][1] + j * basis[1][1]) for i in range(-4, 5) for j in range(-4, 5)]

            def ring(turn):
                at = np.radians(np.arange(0, 360, 2) + turn)
                x, y = radius * np.cos(at), radius * np.sin(at)
                return sum(np.exp(-((x - p) ** 2 + (y - q) ** 2) / (4 * 0.11**2)) for p, q in peaks)

            first, weight = ring(0), radius * np.ones((1, 180))
            c = {turn: np.cov(first.ravel(), ring(turn).ravel(), aweights=weight.ravel()) for turn in (30, 60, 90, 120, 150)}
            c = {turn: of[0, 1] / math.sqrt(of[0, 0] * of[1, 1]) for turn, of in c.items()}
            return min(c[60], c[120]) - max(c[30], c[90], c[150]), (c[60] + c[120]) / 2 - (c[30] + c[90] + c[150]) / 3

        for inner, outer in ((0, 1.25), (0.3, 1.25), (0.5, 1.25), (0.5, 1.6), (0.5, 2)):
            by_extremes, by_means = scores(inner, outer, 90)
            self.assertLess(by_extremes, -0.8, (inner, outer))
            self.assertGreater(by_extremes, -1.5)
            self.assertLess(by_means, -0.25, (inner, outer))
            self.assertGreater(by_means, -0.6)
            self.assertGreater(scores(inner, outer, 60)[0], 0.8)
        self.assertAlmostEqual(spatial.grid_scores(lattice(math.radians(90))).sargolini, scores(0.3, 1.25, 90)[0], delta=0.15)
        self.assertAlmostEqual(spatial.grid_scores(lattice(math.radians(60))).sargolini, scores(0.3, 1.25, 60)[0], delta=0.15)

    def test_noise_and_constants_have_no_grid(self):
        rng = np.random.default_rng(9)
        scores = [spatial.grid_scores(rng.random((30, 30))).sargolini for _ in range(20)]
        self.assertLess(abs(np.nanmean(scores)), 0.3)
        self.assertTrue(math.isnan(spatial.grid_scores(np.ones((30, 30))).sargolini))
        self.assertTrue(math.isnan(spatial.grid_scores(np.full((30, 30), np.nan)).sargolini))

    def test_information_fields_correlation_and_width(self):
        rates, visits = np.zeros((8, 8)), np.full((8, 8), 3)
        rates[2:4, 2:4] = 5
        self.assertAlmostEqual(spatial.spatial_information(rates, visits), 4)  # a sixteenth: log2 16
        masked = np.where(np.arange(8) < 6, rates, np.nan)
        self.assertAlmostEqual(spatial.spatial_information(masked, visits),
                               spatial.spatial_information(rates, np.where(np.isnan(masked), 0, visits)))
        self.assertTrue(math.isnan(spatial.spatial_information(np.full((8, 8), np.nan), visits)))
        self.assertTrue(math.isnan(spatial.spatial_information(np.full((8, 8), np.inf), visits)))
        self.assertAlmostEqual(spatial.spatial_information(rates, visits / 3600), spatial.spatial_information(rates, visits))
        for wrong in (visits[:, :1], -visits):
            with self.assertRaisesRegex(ValueError, "visits must have the shape"):
                spatial.spatial_information(rates, wrong)
        self.assertEqual(spatial.spatial_information(np.zeros((8, 8)), visits), 0)  # a unit that never fires
        rates[6, 6:8] = 3
        self.assertEqual(sorted(spatial.fields(rates)), [2, 4])
        self.assertEqual(spatial.fields(np.zeros((3, 3))), [])
        self.assertAlmostEqual(spatial.correlation(rates, 2 * rates + 1), 1)
        self.assertTrue(math.isnan(spatial.correlation(rates, np.ones((8, 8)))))
        angle = np.arange(360) * math.pi / 180
        self.assertAlmostEqual(spatial.half_width(1 + np.cos(angle)), math.pi / 2, places=2)
        self.assertTrue(math.isnan(spatial.half_width(np.ones(36))))


class RunsTest(Systems):
    def scores(self, cells):
        config = self.folder / f"{cells}.yaml"
        config.write_text(f"source: {{plugin: python, file: {models.path('trajectory')}, side: 15, speed: 2, view_radius: 1}}\n"
                          "odometry: {plugin: motion_replay}\nplace: {plugin: place_replay, relative_pose: true, view_step: 1000}\n"
                          f"cells: {{plugin: {cells}, period: 4, experience_spacing: 1, loop_spacing: 1, loop_minimum_travel: 10}}\n"
                          "map: {plugin: experience_map}\nrecord: {report: false}\n")
        more = ("--set", "cells.drift_position=0.01", "--set", "cells.view_sigma_position=0.3") if cells[0] == "b" else ()
        done = program("run", config, "--quiet", "--out", self.folder / cells, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        run = tolman.Run(self.folder / cells)
        table = run.scores("grid.activity", bin_m=0.5, units=20, shuffles=40)
        return {name: float(np.median(table[name])) for name in ("sargolini", "square", "stability", "sargolini_chance")}, run

    def test_the_sheet_is_hexagonal_and_the_bayesian_torus_square_as_metrics_say(self):
        sheet, run = self.scores("can_sheet")
        self.assertGreater(sheet["sargolini"], 0.8)
        self.assertGreater(sheet["sargolini"], sheet["sargolini_chance"] + 0.3)
        self.assertGreater(sheet["stability"], 0.8)
        self.assertAlmostEqual(sheet["sargolini"], run.metrics["cells"]["grid"][0]["grid_score_sargolini"]["median"], delta=0.15)
        torus, run = self.scores("bayesian_attractor")
        self.assertLess(torus["sargolini"], 0)
        self.assertGreater(torus["square"], 0.8)
        self.assertAlmostEqual(torus["square"], run.metrics["cells"]["grid"][0]["grid_score_square"]["median"], delta=0.15)


if __name__ == "__main__":
    unittest.main()
