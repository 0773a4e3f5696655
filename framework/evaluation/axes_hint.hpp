// SPDX-License-Identifier: BSD-3-Clause
// Detects truth in other axes than those of the estimate: poses of the vehicle's body instead of
// the camera, world-to-camera poses, quaternions in another order. An alignment moves the world of
// the estimate, not its camera, so position errors alone do not show this.
#pragma once

#include <string>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// A warning if the directions of motion, each in its camera's own axes, differ by more than 45
/// degrees in the mean and one rotation, or inverting the true poses, brings them within 15
/// degrees; else empty.
std::string axesHint(const Matches& matches);

}  // namespace tolman::evaluation
