# SPDX-License-Identifier: BSD-3-Clause
"""Recorded activity of populations, firing rate maps and tuning curves."""
import math
from dataclasses import dataclass

import numpy as np

from tolman.records import ArrayInfo


@dataclass
class Array:
    """A named array over the frames of a run."""

    info: ArrayInfo
    frames: np.ndarray
    stamps_ns: np.ndarray
    values: np.ndarray  # frames x the shape of the array; one array a frame where the shape is not always the same

    def __array__(self, dtype=None):
        return np.asarray(self.values, dtype)

    @property
    def unit(self):
        return self.info.unit

    @property
    def axes(self):
        return self.info.axes

    @property
    def periods(self):
        """Length of each periodic axis, in its unit; 0 for others."""
        return [axis.period for axis in self.axes]

    @property
    def phases(self):
        """What the indices of each axis stand for, within the period of a periodic one."""
        phases = []
        for axis, size in zip(self.axes, self.values.shape[1:]):
            value = axis.first + axis.step * np.arange(size)
            phases.append(value % axis.period if axis.period > 0 else value)
        return phases


@dataclass
class RateMaps:
    """Firing rate maps; NaN in bins without visits."""

    values: np.ndarray  # the shape of the population x bins forward x bins left
    visits: np.ndarray  # frames in each bin
    x_m: np.ndarray  # edges of the bins, forward
    y_m: np.ndarray  # edges of the bins, left


@dataclass
class Tuning:
    """Tuning curves over heading; NaN in bins without visits."""

    values: np.ndarray  # the shape of the population x bins
    heading_rad: np.ndarray  # centres of the bins
    mean_vector_length: np.ndarray  # of each unit: 1 for one direction only, 0 for none
    preferred_rad: np.ndarray  # in [0, 2 pi)


def _means(index, rates, bins):
    """Mean rate of every unit in every bin, and visits."""
    visits = np.bincount(index, minlength=bins)
    sums = np.zeros((bins, rates.shape[1]))
    np.add.at(sums, index, rates)
    with np.errstate(invalid="ignore", divide="ignore"):
        return (sums / visits[:, None]).T, visits


def _edges(values, bin_m):
    low = math.floor(values.min() / bin_m) if len(values) else 0
    high = math.floor(values.max() / bin_m) + 1 if len(values) else 1
    return bin_m * np.arange(low, high + 1)


def rate_maps(x, y, rates, shape, bin_m=None):
    """`rates`: one row a moment, one column a unit; `shape` of the population."""
    if bin_m is None:
        bin_m = max(np.ptp(x), np.ptp(y), 1e-3) / 24 if len(x) else 1.0
    edges_x, edges_y = _edges(x, bin_m), _edges(y, bin_m)
    rows, columns = len(edges_x) - 1, len(edges_y) - 1
    row = np.clip(np.searchsorted(edges_x, x, "right") - 1, 0, rows - 1)
    column = np.clip(np.searchsorted(edges_y, y, "right") - 1, 0, columns - 1)
    means, visits = _means(row * columns + column, rates, rows * columns)
    return RateMaps(means.reshape(*shape, rows, columns), visits.reshape(rows, columns), edges_x, edges_y)


def tuning(heading, rates, shape, bins=36):
    """The mean vector is that of the curve, so that headings count alike however often they occur."""
    index = np.minimum((np.asarray(heading) % (2 * math.pi) / (2 * math.pi) * bins).astype(int), bins - 1)
    means, _ = _means(index, rates, bins)
    centres = (np.arange(bins) + 0.5) * 2 * math.pi / bins
    known = np.nan_to_num(means)
    vector = known @ np.exp(1j * centres)
    total = known.sum(axis=1)
    length = np.divide(np.abs(vector), total, out=np.zeros_like(total), where=total > 0)
    preferred = np.angle(vector) % (2 * math.pi)
    return Tuning(means.reshape(*shape, bins), centres, length.reshape(shape), preferred.reshape(shape))
