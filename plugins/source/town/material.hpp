// SPDX-License-Identifier: BSD-3-Clause
// Albedo of a point of the town, averaged over the pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "street_plan.hpp"
#include "surface.hpp"
#include "vec3.hpp"

namespace tolman::town {

/// Intersection of a ray and a surface, in the axes of the surface's pattern.
struct SurfaceHit {
  Vec3 point;
  Vec3 normal;  ///< unit, towards the camera
  Vec3 dx;      ///< m, change of the point on the tangent plane to the next pixel of the row
  Vec3 dy;      ///< m, the same along a column; both are the footprint of the pixel
  std::uint32_t seed = 0;

  /// Longer side of the footprint, m.
  float footprint() const { return std::sqrt(std::max(dot(dx, dx), dot(dy, dy))); }
  /// Extent of the footprint along an axis, m.
  float extent(const Vec3& axis) const { return std::abs(dot(dx, axis)) + std::abs(dot(dy, axis)); }
};

/// Albedo in [0, 1]. `plan` gives the distance to the street, on which the material of the land
/// depends.
float albedo(const Surface& surface, const SurfaceHit& hit, const StreetPlan& plan);

/// Share of the pixel that is covered by lit windows of a facade.
float litWindows(const Surface& surface, const SurfaceHit& hit);

/// Share of the pixel that is covered by glass, in windows of houses and cars.
float glassShare(const Surface& surface, const SurfaceHit& hit);
float windowGlass(const Surface& surface, const SurfaceHit& hit);
float carGlass(const SurfaceHit& hit);

// One function for each group of materials; albedo() selects it.
float groundAlbedo(const Surface& surface, const SurfaceHit& hit, const StreetPlan& plan);
float buildingAlbedo(const Surface& surface, const SurfaceHit& hit);
float plantAlbedo(const Surface& surface, const SurfaceHit& hit);
float objectAlbedo(const Surface& surface, const SurfaceHit& hit);

}  // namespace tolman::town
