// SPDX-License-Identifier: BSD-3-Clause
// Whether an alignment of positions determines the rotation of the estimate about the path.
#pragma once

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// True if an alignment in three dimensions does not separate horizontal from vertical errors: a
/// quarter turn about a principal direction of the truth increases the root mean square error by
/// less than 5 %, and turns about it move more than a tenth of the squared error between horizontal
/// and vertical. This is the case on a straight path, where all turns about it have the same error.
bool turnIsOpen(const Matches& aligned);

/// True if the orientations of the estimate contradict the alignment, and its positions do not
/// refute them: a turn of the estimate about its mean position tilts the vertical (y) by more than
/// 10 degrees, and after it the root mean square error is at most three times as large, or below
/// 1 % of the true path. The turn is the one that brings the estimated orientations nearest to the
/// true ones, or its part about a principal direction of the truth. Positions alone would exchange
/// horizontal and vertical errors where the path is straight but for swings smaller than the error.
bool turnIsContradicted(const Matches& aligned);

}  // namespace tolman::evaluation
