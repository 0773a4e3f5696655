// SPDX-License-Identifier: BSD-3-Clause
// Detects true poses of a camera that is turned, or mirrored, against that of the estimate by so
// little, or about such an axis, that positions and directions of motion nearly agree.
#pragma once

#include <string>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// A warning if true and estimated directions of motion differ by 4 degrees or more in the mean, or
/// the axes of their turns by 15, and one rotation of the camera leaves less than half of that;
/// else empty. Directions and axes are each in the axes of the own camera.
std::string turnedAxesHint(const Matches& matches);

/// A warning if the turns from frame to frame about one axis of the camera are opposite: their
/// correlation over 30 frames or more is below -0.5, and four standard deviations of that of noise;
/// else empty.
std::string oppositeAxisHint(const Matches& matches);

}  // namespace tolman::evaluation
