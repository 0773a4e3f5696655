// SPDX-License-Identifier: BSD-3-Clause
// Detects runs whose errors must not be averaged.
#pragma once

#include <vector>

#include "experiment/run_table.hpp"

namespace tolman::experiment {

using RunPointers = std::vector<const RunRow*>;
RunPointers pointersTo(const std::vector<RunRow>& rows);

/// InvalidInput for runs with different alignments, and for runs of one sequence with different
/// true poses or coverages. With `mixed_coverage` coverages may differ.
Status refuseMixtures(const RunPointers& runs, bool mixed_coverage);

}  // namespace tolman::experiment
