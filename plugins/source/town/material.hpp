// SPDX-License-Identifier: BSD-3-Clause
// Albedo of points of the town, averaged over the pixel: eight points of one surface at once, which
// is what most packets of rays meet.
// Effects of rain and snow on surfaces.
#pragma once

#include <cstdint>

#include "lanes.hpp"
#include "light.hpp"
#include "street_plan.hpp"
#include "vec3.hpp"
#include "world.hpp"

namespace tolman::town {

/// Intersections of eight rays and a surface, in the axes of the surface's pattern.
struct SurfaceHits {
  Vec3s point;
  Vec3s normal;  ///< unit, towards the camera
  Vec3s dx;      ///< m, change of the point on the tangent plane to the next pixel of the row
  Vec3s dy;      ///< m, the same along a column; both are the footprint of the pixel
  EightWords seed;

  /// Longer side of the footprint, m.
  TOLMAN_INLINE Eight footprint() const { return squareRoot(larger(dot(dx, dx), dot(dy, dy))); }
  /// Extent of the footprint along an axis, m.
  TOLMAN_INLINE Eight extent(const Vec3& axis) const {
    const Vec3s a = vec3s(axis);
    return absolute(dot(dx, a)) + absolute(dot(dy, a));
  }
};

/// Albedos in [0, 1]. `plan` gives the distance to the street, on which the material of the land
/// depends.
void albedos(const Surface& surface, const SurfaceHits& hits, const StreetPlan& plan,
             Eight& result);

/// Shares of the pixels that are covered by lit windows of a facade.
void litWindows(const Surface& surface, const SurfaceHits& hits, Eight& result);

// One function for each group of materials; albedos() selects it.
void groundAlbedos(const Surface& surface, const SurfaceHits& hits, const StreetPlan& plan,
                   Eight& result);
void buildingAlbedos(const Surface& surface, const SurfaceHits& hits, Eight& result);
void plantAlbedos(const Surface& surface, const SurfaceHits& hits, Eight& result);
void objectAlbedos(const Surface& surface, const SurfaceHits& hits, Eight& result);

/// Albedo of a surface whose dry albedo is `dry`. `normal` and `point` in town axes.
float weatheredAlbedo(float dry, const Surface& surface, const Vec3& point, const Vec3& normal,
                      float footprint, const Light& light, const StreetPlan& plan);

}  // namespace tolman::town
