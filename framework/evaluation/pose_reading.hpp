// SPDX-License-Identifier: BSD-3-Clause
// Detects a true and an estimated trajectory that are both of another convention than camera to
// world. Their errors compare like with like, but they are not those of the path.
#pragma once

#include <string>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// A warning if both trajectories, as they are read, move in all directions of their own camera,
/// but in one direction if every pose or only its rotation is inverted, or if poses are motions
/// from frame to frame; else empty. A camera that is carried by hand or flown has no such
/// direction, so nothing is told of it, nor of a straight path.
std::string poseReadingHint(const Matches& matches);

}  // namespace tolman::evaluation
