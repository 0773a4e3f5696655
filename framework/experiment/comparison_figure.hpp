// SPDX-License-Identifier: BSD-3-Clause
// A comparison as a figure for a column of a paper.
#pragma once

#include <string>

#include "experiment/comparison.hpp"

namespace tolman::experiment {

/// SVG. Where the first factor has numbers, the metric over it: mean with its interval as a band,
/// one line for each level of the other factors. Otherwise a box for each level (quartiles, median,
/// the whole range) over its runs as dots.
std::string comparisonFigure(const Comparison& comparison);

}  // namespace tolman::experiment
