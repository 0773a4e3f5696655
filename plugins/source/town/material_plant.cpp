// SPDX-License-Identifier: BSD-3-Clause
// Leaves and bark: noise in three dimensions, in axes of the plant.
#include "dispatch.hpp"
#include "material.hpp"
#include "noise.hpp"

namespace tolman::town {
namespace {

/// Bright leaves before dark gaps: the strongest texture of a real street.
float leaves(const Surface& surface, const SurfaceHit& hit) {
  // Leaves have all orientations, so a slanting surface of leaves is foreshortened less than a
  // wall.
  const float footprint = std::sqrt(norm(hit.dx) * norm(hit.dy));
  const auto [boughs, clumps, leaf, scraps] = layers3(hit.point, 2.4F, footprint, hit.seed);
  const float tuft = 0.35F * clumps + 1.0F * leaf + 0.8F * scraps;
  const float gap = smoothstep(0.05F, 0.4F, -tuft);
  const float shine = smoothstep(0.05F, 0.6F, tuft);
  return surface.tone * std::max(0.05F, (1 + 0.3F * boughs) * (0.8F - 0.72F * gap + 1.9F * shine));
}

float bark(const Surface& surface, const SurfaceHit& hit) {
  const Vec3 stretched = {hit.point.x * 3, hit.point.y * 3, hit.point.z * 0.6F};
  const float furrows = fractal3(stretched, 0.3F, 3, 3 * hit.footprint(), hit.seed);
  return surface.tone * std::max(0.2F, 1 + 0.7F * furrows);
}

}  // namespace

TOLMAN_TOWN_DISPATCH [[gnu::flatten]] float plantAlbedo(const Surface& surface,
                                                        const SurfaceHit& hit) {
  return surface.material == Material::Leaves ? leaves(surface, hit) : bark(surface, hit);
}

}  // namespace tolman::town
