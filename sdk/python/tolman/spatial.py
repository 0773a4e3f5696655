# SPDX-License-Identifier: BSD-3-Clause
"""Measures of single units of spatial cells, from rate maps (NaN in bins without visits) and tuning curves."""
import math
from dataclasses import dataclass

import numpy as np

LEAST_OVERLAP = 20  # bins that a correlation is computed from (Sargolini et al. 2006)
FIELD = 0.2  # of the peak: a bin above it is part of a field


def autocorrelogram(rates):
    """Pearson's correlation of a map with itself by displacement, over the bins that both copies have visited."""
    known = np.isfinite(rates)
    filled = np.where(known, rates - np.mean(rates[known]), 0) if known.any() else np.zeros(rates.shape)
    size = [2 * side - 1 for side in rates.shape]

    def sums(a, b):
        product = np.fft.rfft2(a, size) * np.conj(np.fft.rfft2(b, size))
        return np.fft.fftshift(np.fft.irfft2(product, size))

    one = known.astype(float)
    n = np.round(sums(one, one))
    a, b, ab = sums(filled, one), sums(one, filled), sums(filled, filled)
    aa, bb = sums(filled**2, one), sums(one, filled**2)
    with np.errstate(invalid="ignore", divide="ignore"):
        spread = (n * aa - a**2) * (n * bb - b**2)
        return np.where((n >= LEAST_OVERLAP) & (spread > 1e-12 * (n * np.sum(filled**2)) ** 2), (n * ab - a * b) / np.sqrt(spread), np.nan)


@dataclass
class GridScores:
    """NaN where a map has no neighbouring fields."""

    sargolini: float = math.nan  # r(60) - max(r(30), r(90)) of the ring of the nearest peaks (Sargolini et al. 2006)
    langston: float = math.nan  # the best of all rings that grow outwards (Langston et al. 2010)
    square: float = math.nan  # r(90) - r(45) of the ring of the nearest peaks
    spacing: float = math.nan  # distance of the nearest peaks, in bins


def _turned(r, centre, radius):
    """The values on circles, one row a radius, 120 angles."""
    angle = np.arange(120) * 2 * math.pi / 120
    x, y = (centre[i] + radius[:, None] * wave for i, wave in enumerate((np.cos(angle), np.sin(angle))))
    i, j = np.floor(x).astype(int), np.floor(y).astype(int)
    u, v = x - i, y - j

    def at(rows, columns):
        return r[np.clip(rows, 0, r.shape[0] - 1), np.clip(columns, 0, r.shape[1] - 1)]

    return (1 - u) * ((1 - v) * at(i, j) + v * at(i, j + 1)) + u * ((1 - v) * at(i + 1, j) + v * at(i + 1, j + 1))


def _correlations(rings, radius):
    """Of the rings with themselves after 30, 45, 60 and 90 degrees; a radius weighs as much as its length. After 120 and 150 degrees they are those
    of 60 and 30, because an autocorrelogram is the same after half a turn."""
    weight = np.broadcast_to(radius[:, None], rings.shape).ravel()
    found = []
    for steps in (10, 15, 20, 30):
        x, y = rings.ravel(), np.roll(rings, -steps, axis=1).ravel()
        both = np.isfinite(x) & np.isfinite(y)
        found.append(_pearson(x[both], y[both], weight[both]))
    return found


def _pearson(x, y, weight=None):
    if len(x) < 2:
        return math.nan
    weight = np.ones(len(x)) if weight is None else weight
    x, y = x - np.average(x, weights=weight), y - np.average(y, weights=weight)
    spread = math.sqrt(np.sum(weight * x * x) * np.sum(weight * y * y))
    return float(np.sum(weight * x * y) / spread) if spread > 0 else math.nan


def _peak_distance(r, centre, ring):
    """Mean distance of the peaks around the centre. `ring`: the maximum of the radial mean, which lies further out, as
    the flank of a square lattice's ring holds its diagonal neighbours."""
    i, j = np.indices(r.shape)
    away = np.hypot(i - centre[0], j - centre[1])
    padded = np.pad(np.nan_to_num(r, nan=-2), 1, constant_values=-2)
    around = [padded[1 + di:padded.shape[0] - 1 + di, 1 + dj:padded.shape[1] - 1 + dj]
              for di in (-1, 0, 1) for dj in (-1, 0, 1) if di or dj]
    is_peak = np.isfinite(r) & (np.nan_to_num(r, nan=-2) >= np.max(around, axis=0)) & (away >= 0.6 * ring) & (away <= 1.25 * ring)
    if not is_peak.any() or r[is_peak].max() <= 0:
        return float(ring)
    distances = away[is_peak & (np.nan_to_num(r, nan=-2) >= 0.5 * r[is_peak].max())]
    return float(distances[distances <= 1.2 * distances.min()].mean())


def grid_scores(rates):
    """Of one rate map."""
    reach = int(2 / 3 * min(rates.shape))
    if reach < 4 or not np.isfinite(rates).any():
        return GridScores()
    r = autocorrelogram(rates)
    centre = [side // 2 for side in r.shape]
    if np.isnan(r[tuple(centre)]):
        return GridScores()
    radius = np.arange(reach + 1)
    rings = _turned(r, centre, radius.astype(float))
    some = np.isfinite(rings).any(axis=1)
    mean = np.array([np.nanmean(ring) if ok else -1 for ring, ok in zip(rings, some)])
    inner = 1
    while inner + 1 < len(mean) and mean[inner] >= 0.2 and mean[inner + 1] <= mean[inner]:
        inner += 1
    peaks = [d for d in range(inner + 1, reach) if mean[d] >= mean[d - 1] and mean[d] >= mean[d + 1]]
    if not peaks:
        return GridScores()
    best = max(peaks, key=lambda d: mean[d])
    nearest = next(d for d in peaks if d == best or mean[d] >= 0.5 * mean[best] > 0)
    scores = GridScores(spacing=_peak_distance(r, centre, nearest))
    outer = min(reach, round(1.25 * nearest))
    for last in range(inner + 2, reach + 1):
        chosen = radius[inner + 1:last + 1]
        r30, r45, r60, r90 = _correlations(rings[chosen], chosen.astype(float))
        hexagonal = r60 - max(r30, r90)
        scores.langston = float(np.fmax(scores.langston, hexagonal))
        if last == outer:
            scores.sargolini, scores.square = hexagonal, r90 - r45
    return scores


def spatial_information(rates, visits):
    """Bits a spike (Skaggs et al. 1992), over the bins that were visited and have a rate; NaN where no bin has one, or one is infinite."""
    if np.shape(rates) != np.shape(visits) or np.any(np.asarray(visits) < 0):
        raise ValueError("visits must have the shape of the rate map, and no value below 0")
    known = (visits > 0) & ~np.isnan(rates)
    if not known.any() or np.isinf(rates[known]).any():
        return np.nan
    share = visits[known] / visits[known].sum()
    mean = np.sum(share * rates[known])
    if not mean > 0:
        return 0.0
    ratio = rates[known] / mean
    return float(np.sum(share * ratio * np.log2(np.where(ratio > 0, ratio, 1))))


def fields(rates):
    """Sizes of the fields in bins: bins that touch and fire above a fifth of the peak."""
    open_bins = np.nan_to_num(rates) > FIELD * np.nanmax(rates, initial=0) if np.nanmax(rates, initial=0) > 0 else np.zeros(rates.shape, bool)
    sizes = []
    for start in zip(*np.nonzero(open_bins)):
        queue, size = [start], 0
        while queue:
            i, j = queue.pop()
            if 0 <= i < rates.shape[0] and 0 <= j < rates.shape[1] and open_bins[i, j]:
                open_bins[i, j], size = False, size + 1
                queue += [(i + di, j + dj) for di in (-1, 0, 1) for dj in (-1, 0, 1)]
        if size:
            sizes.append(size)
    return sizes


def correlation(a, b):
    """Of two rate maps over the bins that both have: stability of halves of a run, remapping between rooms."""
    both = np.isfinite(a) & np.isfinite(b)
    return _pearson(a[both], b[both])


def half_width(curve):
    """Half the width of a tuning curve at half of its peak, in rad; NaN where it never falls so low."""
    known = np.nan_to_num(curve)
    peak, size = int(np.argmax(known)), len(known)
    total = 0.0
    for side in (1, -1):
        values = known[(peak + side * np.arange(size // 2 + 1)) % size]
        below = np.nonzero(values < 0.5 * values[0])[0]
        if not len(below) or not values[0] > 0:
            return math.nan
        k = below[0]
        total += k - (0.5 * values[0] - values[k]) / (values[k - 1] - values[k])
    return total / 2 * 2 * math.pi / size
