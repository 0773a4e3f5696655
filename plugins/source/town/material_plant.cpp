// SPDX-License-Identifier: BSD-3-Clause
// Leaves and bark: noise in three dimensions, in axes of the plant.
#include "material.hpp"
#include "noise_lanes.hpp"
#include "wide_lanes.hpp"

namespace tolman::town {
namespace {

/// Bright leaves before dark gaps: the strongest texture of a real street.
TOLMAN_INLINE Eight leaves(const Surface& surface, const SurfaceHits& hits) {
  // Leaves have all orientations, so a slanting surface of leaves is foreshortened less than a
  // wall.
  const Eight footprint = squareRoot(norm(hits.dx) * norm(hits.dy));
  const auto [boughs, clumps, leaf, scraps] = layers3(hits.point, 2.4F, footprint, hits.seed);
  const Eight tuft = 0.35F * clumps + 1.0F * leaf + 0.8F * scraps;
  const Eight gap = smoothstep(0.05F, 0.4F, -tuft);
  const Eight shine = smoothstep(0.05F, 0.6F, tuft);
  return surface.tone * larger((1 + 0.3F * boughs) * (0.8F - 0.72F * gap + 1.9F * shine), 0.05F);
}

TOLMAN_INLINE Eight bark(const Surface& surface, const SurfaceHits& hits) {
  const Vec3s stretched = {hits.point.x * 3, hits.point.y * 3, hits.point.z * 0.6F};
  const Eight furrows = fractal3(stretched, 0.3F, 3, 3 * hits.footprint(), hits.seed);
  return surface.tone * larger(1 + 0.7F * furrows, 0.2F);
}

}  // namespace

TOLMAN_WIDE_LANES
void plantAlbedos(const Surface& surface, const SurfaceHits& hits, Eight& result) {
  result = surface.material == Material::Leaves ? leaves(surface, hits) : bark(surface, hits);
}

}  // namespace tolman::town
