// SPDX-License-Identifier: BSD-3-Clause
// What speaks against a truth or an estimate before anyone believes its figures: is one of the two
// read wrongly (hypotheses.hpp), or broken somewhere (step_series.hpp)? Doubts stand beside the
// scores and change none of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/alignment.hpp"
#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// One sentence for each doubt: what was found, and what to look for. Empty for plausible
/// trajectories, whatever the errors of the estimate. Arguments as for score().
std::vector<std::string> doubts(const Trajectory& truth, const Trajectory& estimate,
                                Alignment alignment, std::int64_t max_difference_ns = -1);

/// All doubts in one text; empty without any.
std::string doubtText(const std::vector<std::string>& doubts);

}  // namespace tolman::evaluation
