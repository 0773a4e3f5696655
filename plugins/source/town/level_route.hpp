// SPDX-License-Identifier: BSD-3-Clause
// A route whose passes disagree in height, bent until they agree.
#pragma once

#include "route.hpp"

namespace tolman::town {

/// Where passes of the route meet, all come to their mean height, over some 100 m of driving before
/// and after; the pitch follows the slope. Positions over the ground, yaw and roll stay.
CameraRoute levelled(const CameraRoute& route, double camera_height);

}  // namespace tolman::town
