// SPDX-License-Identifier: BSD-3-Clause
// Correction of the heights of a route whose passes disagree.
#pragma once

#include "route.hpp"

namespace tolman::town {

/// Moves passes that meet to their mean height, over some 100 m of driving before and after. The
/// pitch follows the slope. Horizontal positions, yaw and roll do not change.
CameraRoute levelled(const CameraRoute& route, double camera_height);

}  // namespace tolman::town
