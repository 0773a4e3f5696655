// SPDX-License-Identifier: BSD-3-Clause
// Cars, fences, posts, boards; leaves and bark: noise in three dimensions, in axes of the plant.

#include "lanes.hpp"
#include "material.hpp"
#include "wide_lanes.hpp"

namespace tolman::town {

namespace {

TOLMAN_INLINE Eight wood(const Surface& surface, const SurfaceHits& hits) {
  const Vec3s local = hits.point - vec3s(surface.origin);
  const Eight u = dot(local, vec3s(surface.axis_u));
  const Eight eu = hits.extent(surface.axis_u);
  const Eight gaps = filteredStripes(0.14F, 0.025F, u, eu);
  const auto tone = [&](EightInts board) TOLMAN_INLINE_LAMBDA {
    return between(hash(words(board), surface.seed), -0.3F, 0.3F);
  };
  // The edges of a board are in the middle of the gaps.
  const Eight single = survives(0.14F, eu) * filteredCells(0.14F, u - 0.0125F, eu, tone);
  const Eight grain = fractal2(u * 4, dot(local, vec3s(surface.axis_v)), 0.5F, 3,
                               4 * hits.footprint(), surface.seed);
  return surface.tone * larger(1 + single + 0.3F * grain - 0.7F * gaps, 0.1F);
}

TOLMAN_INLINE Eight glassOfCar(const SurfaceHits& hits) {
  const EightInts upright = absolute(hits.normal.z) < 0.85F;
  const Eight glass = filteredPulse(0.92F, 1.34F, hits.point.z, hits.extent({0, 0, 1}));
  const Eight pillars = filteredStripes(1.15F, 0.09F, hits.point.x + 0.4F, hits.extent({1, 0, 0}));
  return select(upright, glass, Eight{}) * (1 - pillars);
}

/// Bodywork in the tone of the car, with a dark band of windows.
TOLMAN_INLINE Eight body(const Surface& surface, const SurfaceHits& hits) {
  const Eight z = hits.point.z;
  const Eight ez = hits.extent({0, 0, 1});
  const Eight tone = surface.tone * between(hash(hits.seed, 1), 0.15F, 1.3F);
  const Eight trim = filteredPulse(0.45F, 0.5F, z, ez) + filteredPulse(0.2F, 0.27F, z, ez);
  const Eight panel = tone * (1 - 0.6F * smaller(trim, 1.0F)) *
                      (1 + 0.1F * fractal3(hits.point, 0.6F, 3, hits.footprint(), hits.seed));
  return panel + glassOfCar(hits) * (0.04F - panel);
}

/// Posters: a few large shapes and lines of "writing".
TOLMAN_INLINE Eight board(const Surface& surface, const SurfaceHits& hits) {
  const Vec3s local = hits.point - vec3s(surface.origin);
  const Eight u = dot(local, vec3s(surface.axis_u));
  const Eight v = dot(local, vec3s(surface.axis_v));
  const Eight eu = hits.extent(surface.axis_u);
  const Eight ev = hits.extent(surface.axis_v);
  const std::uint32_t seed = surface.seed;
  const Eight shapes = fractal2(u, v, 0.5F * surface.width, 4, hits.footprint(), seed);
  Eight tone = surface.tone * larger(1 + 0.9F * shapes, 0.1F);
  const Eight line = filteredStripes(0.2F, 0.1F, v, ev) * filteredStep(0.12F, v, ev) *
                     (1 - filteredStep(0.4F * surface.height, v, ev));
  const Eight letters = filteredStripes(between(hash(seed, 2), 0.09F, 0.16F), 0.06F, u, eu);
  tone += line * letters * (0.75F - tone);
  const Eight rim = filteredPulse(0.06F, surface.width - 0.06F, u, eu) *
                    filteredPulse(0.06F, surface.height - 0.06F, v, ev);
  return 0.65F + rim * (tone - 0.65F);
}

TOLMAN_INLINE Eight plain(const Surface& surface, const SurfaceHits& hits) {
  return surface.tone * (1 + 0.15F * fractal3(hits.point, 0.5F, 3, hits.footprint(), surface.seed));
}

}  // namespace

TOLMAN_WIDE_LANES
void objectAlbedos(const Surface& surface, const SurfaceHits& hits, Eight& result) {
  switch (surface.material) {
    case Material::Wood:
      result = wood(surface, hits);
      break;
    case Material::Body:
      result = body(surface, hits);
      break;
    case Material::Board:
      result = board(surface, hits);
      break;
    default:
      result = plain(surface, hits);
  }
}

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

void albedos(const Surface& surface, const SurfaceHits& hits, const StreetPlan& plan,
             Eight& result) {
  switch (surface.material) {
    case Material::Road:
    case Material::Kerb:
    case Material::Land:
    case Material::Paint:
      return groundAlbedos(surface, hits, plan, result);
    case Material::Facade:
    case Material::Roof:
      return buildingAlbedos(surface, hits, result);
    case Material::Leaves:
    case Material::Bark:
      return plantAlbedos(surface, hits, result);
    case Material::Plain:
    case Material::Wood:
    case Material::Body:
    case Material::Board:
      return objectAlbedos(surface, hits, result);
  }
}

}  // namespace tolman::town
