// SPDX-License-Identifier: BSD-3-Clause
// Errors along the path, and maps, from the records of the runs of a comparison.
#pragma once

#include <vector>

#include "experiment/comparison.hpp"
#include "experiment/comparison_figure.hpp"

namespace tolman::experiment {

/// The position error (m) of each level over the driven path (m) in 100 parts: mean of its runs,
/// and quartiles as a band. InvalidInput for records that cannot be read.
Result<std::vector<Line>> errorLines(const Comparison& comparison);

/// The map of the median run of each level, x right and y forward in m, then the true path.
Result<std::vector<Line>> mapLines(const Comparison& comparison);

}  // namespace tolman::experiment
