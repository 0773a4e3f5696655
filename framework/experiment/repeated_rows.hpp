// SPDX-License-Identifier: BSD-3-Clause
// Runs that were given twice, such as those of two copies of a sweep.
#pragma once

#include <string>
#include <vector>

#include "experiment/run_table.hpp"

namespace tolman::experiment {

/// Keeps one run of each setting (same factors, seed and sequence). Returns a note about the number
/// of removed runs, which have the same results, and about those of them with other figures in
/// spite of the same digest; empty if there are none. InvalidInput for two runs of one setting with
/// different results: they must not be in one statistic.
Result<std::string> mergeRepeats(std::vector<RunRow>& rows);

/// The failure that these two runs of one setting have different results.
Status oneSetting(const RunRow& a, const RunRow& b);

}  // namespace tolman::experiment
