// SPDX-License-Identifier: BSD-3-Clause
// Detects true positions that were written with too few digits.
#pragma once

#include <string>

#include "evaluation/trajectory.hpp"

namespace tolman::evaluation {

/// The unit to which positions were rounded, 1 mm or more, and what it does to the error.
struct Rounding {
  double unit = 0;   ///< m, the coarsest of the axes; 0 if positions are no multiples of one
  double error = 0;  ///< m, root mean square of what the rounding of all axes makes
};

/// The unit of an axis is the greatest one of which all its steps are multiples; it makes an error
/// of u / sqrt(12) in that axis. Both are 0 for an axis in which nothing moves. The error is 0 if
/// all steps are alike, or grow evenly. `truth` must be as it was read: after a rotation it has no
/// units.
Rounding roundingOf(const Trajectory& truth);

/// A warning if that error is over a third of `rmse`, the position error of the estimate, and not
/// so much above it that the positions cannot contain it; else empty.
std::string roundedHint(const Rounding& rounding, double rmse);

}  // namespace tolman::evaluation
