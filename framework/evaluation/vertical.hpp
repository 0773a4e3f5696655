// SPDX-License-Identifier: BSD-3-Clause
// Which part of a position error is vertical: y of the first true camera is down, if its axes are
// those of a camera, and if the alignment determines the roll of the estimate.
#pragma once

#include <string>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// A sentence if the poses move along their own x axis and more along the y than along the z axis
/// of the first pose, as poses with x forward and z up do. Else empty.
std::string upAxisProblem(const Trajectory& truth);

/// Why the x-z plane of the first pose cannot be that of the drive; empty if it can.
std::string planeProblem(const Trajectory& truth);

/// On an almost straight path positions do not determine the roll, so horizontal and vertical
/// errors may be swapped: a quarter turn about a principal direction of the truth increases the
/// root mean square error by less than 5 %, and turns about it move more than a tenth of the
/// squared error between the two.
bool rollIsUnobservable(const Matches& aligned);

/// The orientations of the estimate contradict the alignment, and its positions do not refute them:
/// a turn of the estimate about its mean position tilts the vertical (y) by more than 10 degrees,
/// and after it the root mean square error is at most three times as large, or below 1 % of the
/// true path. The turn is the one that brings the estimated orientations nearest to the true ones,
/// or its part about a principal direction of the truth.
bool rollIsContradicted(const Matches& aligned);

}  // namespace tolman::evaluation
