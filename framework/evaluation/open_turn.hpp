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

}  // namespace tolman::evaluation
