// SPDX-License-Identifier: BSD-3-Clause
// Detects true positions that were written with too few digits.
#pragma once

#include <string>

#include "evaluation/trajectory.hpp"

namespace tolman::evaluation {

/// The units of positions, of 1 mm and more: of decimal digits, degrees, or numbers of 32 bits.
struct Rounding {
  double unit = 0;   ///< m, the coarsest of the axes; 0 if positions are no multiples of one
  double error = 0;  ///< m, root mean square of what the rounding of all axes makes
};

/// Whether all steps along an axis are multiples of a unit. An axis in which nothing moves says
/// nothing. `truth` is as it was read: a rotated world has no
/// units. A unit u makes an error of u / sqrt(12) in its axis,
/// 0 where all steps are alike.
Rounding roundingOf(const Trajectory& truth);

/// A warning if that error is over a third of `rmse`, the position error of the estimate, and not
/// so much above it that the positions cannot contain it; else empty.
std::string roundedHint(const Rounding& rounding, double rmse);

}  // namespace tolman::evaluation
