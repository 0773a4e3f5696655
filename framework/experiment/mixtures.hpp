// SPDX-License-Identifier: BSD-3-Clause
// Detects runs whose errors must not be averaged.
#pragma once

#include <vector>

#include "experiment/run_table.hpp"

namespace tolman::experiment {

/// Coverages (shares of the frames) that differ by less are the same.
inline constexpr double kSameCoverage = 0.02;

using RunPointers = std::vector<const RunRow*>;
RunPointers pointersTo(const std::vector<RunRow>& rows);

/// InvalidInput for runs with different alignments, for runs that tracked nothing, and for runs of
/// one sequence with different true poses or coverages. With `mixed_coverage` coverages may differ.
Status refuseMixtures(const RunPointers& runs, bool mixed_coverage);

/// InvalidInput where `metric` is a drift and was measured over segments of different lengths.
Status refuseMixedLengths(const RunPointers& runs, const std::string& metric);

/// InvalidInput where two sequences have the same results byte for byte in all their runs: copies
/// of one drive would count as independent.
Status refuseCopies(const RunPointers& runs);

}  // namespace tolman::experiment
