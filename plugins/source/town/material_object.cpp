// SPDX-License-Identifier: BSD-3-Clause
// Cars, fences, posts and boards.
#include "dispatch.hpp"
#include "material.hpp"
#include "noise.hpp"
#include "pattern.hpp"

namespace tolman::town {
namespace {

float wood(const Surface& surface, const SurfaceHit& hit) {
  const Vec3 local = hit.point - surface.origin;
  const float u = dot(local, surface.axis_u);
  const float gaps = filteredStripes(0.14F, 0.025F, u, hit.extent(surface.axis_u));
  const float eu = hit.extent(surface.axis_u);
  // The edges of a board are in the middle of the gaps.
  const float single =
      survives(0.14F, eu) * filteredCells(0.14F, u - 0.0125F, eu, [&](int board) {
        return between(hash(static_cast<std::uint32_t>(board), surface.seed), -0.3F, 0.3F);
      });
  const float grain =
      fractal2(u * 4, dot(local, surface.axis_v), 0.5F, 3, 4 * hit.footprint(), surface.seed);
  return surface.tone * std::max(0.1F, 1 + single + 0.3F * grain - 0.7F * gaps);
}

/// Clothes in the tone of the person, darker in folds.
float cloth(const Surface& surface, const SurfaceHit& hit) {
  const float tone = between(hash(hit.seed, 3), 0.04F, 0.6F);
  const Vec3 folds = {hit.point.x, hit.point.y, 0.5F * hit.point.z};
  return tone * std::max(0.3F, 1 + 0.4F * fractal3(folds, 0.2F, 3, hit.footprint(), surface.seed));
}

/// Bodywork in the tone of the car, with a dark band of windows.
float body(const Surface& surface, const SurfaceHit& hit) {
  const float z = hit.point.z;
  const float ez = hit.extent({0, 0, 1});
  const float tone = surface.tone * between(hash(hit.seed, 1), 0.15F, 1.3F);
  const float trim = filteredPulse(0.45F, 0.5F, z, ez) + filteredPulse(0.2F, 0.27F, z, ez);
  const float panel = tone * (1 - 0.6F * std::min(trim, 1.0F)) *
                      (1 + 0.1F * fractal3(hit.point, 0.6F, 3, hit.footprint(), hit.seed));
  return panel + carGlass(hit) * (0.04F - panel);
}

/// Posters: a few large shapes and lines of "writing".
float board(const Surface& surface, const SurfaceHit& hit) {
  const Vec3 local = hit.point - surface.origin;
  const float u = dot(local, surface.axis_u);
  const float v = dot(local, surface.axis_v);
  const float eu = hit.extent(surface.axis_u);
  const float ev = hit.extent(surface.axis_v);
  const std::uint32_t seed = surface.seed;
  const float shapes = fractal2(u, v, 0.5F * surface.width, 4, hit.footprint(), seed);
  float tone = surface.tone * std::max(0.1F, 1 + 0.9F * shapes);
  const float line = filteredStripes(0.2F, 0.1F, v, ev) * filteredStep(0.12F, v, ev) *
                     (1 - filteredStep(0.4F * surface.height, v, ev));
  const float letters = filteredStripes(between(hash(seed, 2), 0.09F, 0.16F), 0.06F, u, eu);
  tone += line * letters * (0.75F - tone);
  const float rim = filteredPulse(0.06F, surface.width - 0.06F, u, eu) *
                    filteredPulse(0.06F, surface.height - 0.06F, v, ev);
  return 0.65F + rim * (tone - 0.65F);
}

}  // namespace

float carGlass(const SurfaceHit& hit) {
  const bool upright = std::abs(hit.normal.z) < 0.85F;
  const float glass =
      upright ? filteredPulse(0.92F, 1.34F, hit.point.z, hit.extent({0, 0, 1})) : 0.0F;
  const float pillars = filteredStripes(1.15F, 0.09F, hit.point.x + 0.4F, hit.extent({1, 0, 0}));
  return glass * (1 - pillars);
}

TOLMAN_TOWN_DISPATCH [[gnu::flatten]] float objectAlbedo(const Surface& surface,
                                                         const SurfaceHit& hit) {
  switch (surface.material) {
    case Material::Wood:
      return wood(surface, hit);
    case Material::Body:
      return body(surface, hit);
    case Material::Board:
      return board(surface, hit);
    case Material::Cloth:
      return cloth(surface, hit);
    default:
      return surface.tone *
             (1 + 0.15F * fractal3(hit.point, 0.5F, 3, hit.footprint(), surface.seed));
  }
}

}  // namespace tolman::town
