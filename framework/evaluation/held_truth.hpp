// SPDX-License-Identifier: BSD-3-Clause
// Detects true poses that are held: repeated bit for bit while the estimate moves on.
#pragma once

#include <string>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// A warning if the true pose is exactly the same for three frames or more while the estimate moves
/// by 0.5 m, or by 1 % of the true path where that is less, and the truth then makes up for it in
/// one step; else empty. A robot that stands moves neither, and interpolated poses differ. The
/// estimate is aligned: its lengths are compared with true ones.
std::string heldHint(const Matches& aligned);

}  // namespace tolman::evaluation
