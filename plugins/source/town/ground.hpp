// SPDX-License-Identifier: BSD-3-Clause
// Road, kerbs and the land beside them as triangles.
#pragma once

#include <cstdint>

#include "mesh.hpp"
#include "street_plan.hpp"

namespace tolman::town {

/// Indices into the table of surfaces.
struct GroundSurfaces {
  std::uint32_t road = 0;
  std::uint32_t kerb = 0;
  std::uint32_t land = 0;  ///< pavement, verge, grass: the material depends on the distance
};

/// A grid of 1 m cells within kFarthest of the streets, cut along the kerb (marching squares on
/// distance() = kRoadHalfWidth): the road at height(), the land kKerbHeight higher, and a vertical
/// kerb between them. Around it is a coarse grid up to `horizon` m, a little lower, so that there
/// is no gap.
Mesh buildGround(const StreetPlan& plan, const GroundSurfaces& surfaces, double horizon = 400);

}  // namespace tolman::town
