// SPDX-License-Identifier: BSD-3-Clause
// Albedo of a point of the town, averaged over the pixel that sees it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "street_plan.hpp"
#include "surface.hpp"
#include "vec3.hpp"

namespace tolman::town {

/// Where a ray met a surface, in the axes that its pattern is anchored in.
struct SurfaceHit {
  Vec3 point;
  Vec3 normal;  ///< unit, towards the camera
  Vec3 dx;      ///< how far the point moves from one pixel to the next along a row, on the tangent
  Vec3 dy;      ///< and along a column: together the footprint of the pixel
  std::uint32_t seed = 0;

  /// m, the longer side of the footprint.
  float footprint() const { return std::sqrt(std::max(dot(dx, dx), dot(dy, dy))); }
  /// m, extent of the footprint along an axis.
  float extent(const Vec3& axis) const { return std::abs(dot(dx, axis)) + std::abs(dot(dy, axis)); }
};

/// In [0, 1]. `plan` gives the distance to the street, on which the material of the land depends.
float albedo(const Surface& surface, const SurfaceHit& hit, const StreetPlan& plan);

/// Share of the pixel that windows of a facade with light behind them cover.
float litWindows(const Surface& surface, const SurfaceHit& hit);

/// Share of the pixel that glass covers, in windows of houses and cars.
float glassShare(const Surface& surface, const SurfaceHit& hit);
float windowGlass(const Surface& surface, const SurfaceHit& hit);
float carGlass(const SurfaceHit& hit);

// One function for each group of materials; albedo() selects it.
float groundAlbedo(const Surface& surface, const SurfaceHit& hit, const StreetPlan& plan);
float buildingAlbedo(const Surface& surface, const SurfaceHit& hit);
float plantAlbedo(const Surface& surface, const SurfaceHit& hit);
float objectAlbedo(const Surface& surface, const SurfaceHit& hit);

}  // namespace tolman::town
