// SPDX-License-Identifier: BSD-3-Clause
// Bridges where a route crosses itself at an angle and at different heights.
#pragma once

#include "route.hpp"
#include "street_plan.hpp"
#include "world.hpp"

namespace tolman::town {

/// The route with the frames of the upper pass marked as raised, 22 m to either side of the lower
/// street. Not marked: crossings with less than 2.5 m between the heights, and passes along the
/// same street, whose heights differ because the true poses drift.
CameraRoute bridged(const CameraRoute& route, double camera_height);

/// Roadway, walkways, railings, slab and abutments of each deck of the plan.
void addBridges(World& world, const StreetPlan& plan);

}  // namespace tolman::town
