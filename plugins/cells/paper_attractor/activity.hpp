// SPDX-License-Identifier: BSD-3-Clause
// Firing rates of the single cells, for recorder and viewers. The network itself needs none.
#pragma once

#include <vector>

#include "spatial_cells.hpp"
#include "tolman/fields.hpp"

namespace tolman::paper_attractor {

/// Rates in [0, 1] of `units` head direction cells; cell i prefers i * 2 pi / units.
std::vector<float> ringActivity(const PeriodicBump<1>& bump, double period, int units);

/// Rates of units x units grid cells, row-major; the cell in row r and column c prefers
/// x = c * period / units and y = r * period / units. Its tuning curve is a Gaussian with a
/// standard deviation of `width` periods; the rate is the expected value under the bump, at most 1.
std::vector<float> torusActivity(const PeriodicBump<2>& bump, double period, int units,
                                 double width = 0);

/// Appends hd.* and grid.*: activity, and the bumps as (mean, precision) or (x, y, precision).
void appendArrays(const SpatialCells& cells, std::vector<NamedArray>& arrays);
void describeArrays(const SpatialCells& cells, std::vector<ArrayInfo>& arrays);

}  // namespace tolman::paper_attractor
