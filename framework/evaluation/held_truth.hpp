// SPDX-License-Identifier: BSD-3-Clause
// Detects true poses that do not follow the robot: held ones, jumps, and orientations that never
// turn.
#pragma once

#include <string>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// A warning if the true pose is exactly the same for three frames or more while the estimate moves
/// by 0.5 m, or by 1 % of the true path where that is less, and either the truth then makes up for
/// it in one step, or the estimate moves on, for five
/// frames or more, at over a quarter of the usual speed of the truth; else empty.
/// The same with the two exchanged. A robot that stands moves neither, an estimate that drifts then
/// is slow, and interpolated poses differ. The estimate is aligned: its lengths are compared with
/// true ones.
std::string heldHint(const Matches& aligned);

/// A warning if the truth makes a single step of 0.5 m or more (1 % of the true path where that is
/// less) that is over four times as long as the steps before and after it, the usual ones (rms),
/// and that of the estimate; else empty. No vehicle moves like that. The estimate is aligned.
std::string jumpHint(const Matches& aligned);

/// A warning if all true orientations are the same and the estimate turns by 90 degrees or more;
/// else empty.
std::string fixedOrientationHint(const Matches& matches);

}  // namespace tolman::evaluation
