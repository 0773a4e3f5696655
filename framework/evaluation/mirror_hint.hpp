// SPDX-License-Identifier: BSD-3-Clause
// Detects a true path that is the mirror image of the estimate's, as of a left-handed coordinate
// system or with one axis of the wrong sign.
#pragma once

#include <string>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// A warning if the best reflection of the estimate fits the true positions at least five times
/// better than the best rotation, whose error is not small; else empty. The scale is kept, and
/// orientations are not used: where only the height is mirrored they hardly differ. A path in one
/// plane is its own mirror image.
std::string mirrorHint(const Matches& aligned);

}  // namespace tolman::evaluation
