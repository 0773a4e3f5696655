// SPDX-License-Identifier: BSD-3-Clause
// Asphalt, kerbs, paint, pavement and grass: patterns are functions of the town's X and Y. Rain and
// snow on all surfaces.

#include <algorithm>
#include <cmath>

#include "lanes.hpp"
#include "material.hpp"
#include "noise.hpp"
#include "wide_lanes.hpp"

namespace tolman::town {

namespace {

/// Octaves of noise for a long, narrow footprint, as in grazing views: the mean of samples along
/// the longer side, each faded by the shorter one.
TOLMAN_INLINE Eight grazingFractal(const SurfaceHits& hits, float wavelength, int octaves,
                                   std::uint32_t seed) {
  const Eight across = dot(hits.dx, hits.dx);
  const Eight along = dot(hits.dy, hits.dy);
  const Vec3s major = select(along > across, hits.dy, hits.dx);
  const Eight longer = squareRoot(larger(along, across));
  const Eight shorter = larger(squareRoot(smaller(along, across)), longer * 0.25F);
  Eight sum = {};
  float amplitude = 0.55F;
  for (int i = 0; i < octaves; ++i, wavelength *= 0.5F, amplitude *= 0.8F) {
    const Eight weight = amplitude * survives(wavelength, shorter);
    if (!any(weight > 0)) break;
    const Eight wanted = clamped(2.5F * longer / wavelength, 1, 4);
    const Eight taps = -floorOf(-wanted);
    const float scale = 1 / wavelength;
    const Eight part = scale / taps;
    const Eight back = 0.5F * (taps - 1);
    const Eight x = major.x * part;
    const Eight y = major.y * part;
    sum += weight * meanNoise2(hits.point.x * scale - x * back, hits.point.y * scale - y * back, x,
                               y, taps, seed + static_cast<std::uint32_t>(i));
  }
  return sum;
}

/// Repaired rectangles, darker or lighter than the rest, with a tarred seam.
TOLMAN_INLINE Eight patches(const SurfaceHits& hits, std::uint32_t seed) {
  constexpr float kPatchCell = 9;  // m
  const Eight cx = floorOf(hits.point.x / kPatchCell);
  const Eight cy = floorOf(hits.point.y / kPatchCell);
  const EightWords h = hash(words(truncated(cx)), words(truncated(cy)), seed);
  const EightInts none = unit(h) > 0.45F;
  if (all(none)) return Eight{};
  const Eight x = hits.point.x - cx * kPatchCell;
  const Eight y = hits.point.y - cy * kPatchCell;
  const Eight left = between(hash(h, 1), 0.5F, 5);
  const Eight low = between(hash(h, 2), 0.5F, 5);
  const Eight right = left + between(hash(h, 3), 0.6F, 3.5F);
  const Eight high = low + between(hash(h, 4), 0.6F, 3.5F);
  const Eight ex = hits.extent({1, 0, 0});
  const Eight ey = hits.extent({0, 1, 0});
  const Eight outer = filteredPulse(left, right, x, ex) * filteredPulse(low, high, y, ey);
  const Eight inner = filteredPulse(left + 0.06F, right - 0.06F, x, ex) *
                      filteredPulse(low + 0.06F, high - 0.06F, y, ey);
  const Eight tone = inner * between(hash(h, 5), -0.35F, 0.25F) - (outer - inner) * 0.5F;
  return select(none, Eight{}, tone);
}

/// Thin dark lines where smooth noise crosses zero.
TOLMAN_INLINE Eight cracks(const SurfaceHits& hits, Eight footprint, std::uint32_t seed) {
  constexpr float kWidth = 0.012F;  // m
  const Eight width = kWidth + 0.7F * footprint;
  const Eight strength = kWidth / width;
  const EightInts visible = strength >= 0.08F;  // not too thin for this pixel
  if (!any(visible)) return Eight{};
  const Eight n = noise2(hits.point.x / 2.3F, hits.point.y / 2.3F, seed);
  // |n| / slope is about the distance to the line; the mean slope is 0.5 a metre.
  const Eight distance = absolute(n) / 0.5F;
  const Eight t = clamped((distance - 0.5F * width) / width, 0, 1);
  return select(visible, strength * (1 - t * t * (3 - 2 * t)), Eight{});
}

TOLMAN_INLINE Eight road(const Surface& surface, const SurfaceHits& hits) {
  const Eight footprint = hits.footprint();
  const Eight grain = grazingFractal(hits, 0.05F, 2, surface.seed);
  const Eight wear = fractal2(hits.point.x, hits.point.y, 7, 3, footprint, surface.seed + 17);
  const Eight detail = 0.85F * grain + 0.25F * wear + patches(hits, surface.seed + 31) -
                       0.6F * cracks(hits, footprint, surface.seed + 47);
  return surface.tone * larger(1 + detail, 0.15F);
}

TOLMAN_INLINE Eight kerb(const Surface& surface, const SurfaceHits& hits) {
  // Stones of about 1 m for any heading of the kerb.
  const Eight along = hits.point.x + hits.point.y;
  const Eight joints = filteredStripes(1, 0.03F, along, hits.extent({1, 1, 0}));
  const Eight stain = fractal2(hits.point.x, hits.point.y, 0.8F, 3, hits.footprint(), surface.seed);
  return surface.tone * larger(1 + 0.35F * stain - 0.6F * joints, 0.2F);
}

TOLMAN_INLINE Eight paint(const Surface& surface, const SurfaceHits& hits) {
  return surface.tone * (1 + 0.3F * grazingFractal(hits, 0.3F, 3, surface.seed));
}

/// Slabs in rows that follow the kerb.
TOLMAN_INLINE Eight pavement(const SurfaceHits& hits, Eight distance, Eight extent,
                             std::uint32_t seed) {
  const Eight rows = filteredStripes(0.4F, 0.025F, distance, extent);
  const Eight across = filteredStripes(0.4F, 0.025F, hits.point.x + 0.37F * hits.point.y,
                                       hits.extent({1, 0.37F, 0}));
  const Eight slabs = fractal2(hits.point.x, hits.point.y, 0.9F, 4, extent, seed);
  return 0.27F * larger(1 + 0.7F * slabs - 0.45F * larger(rows, across), 0.2F);
}

TOLMAN_INLINE Eight grass(const SurfaceHits& hits, Eight extent, std::uint32_t seed) {
  const Eight x = hits.point.x;
  const Eight y = hits.point.y;
  // Mown lawns have little texture, meadows much; it changes over 60 m.
  const Eight wild = smoothstep(-0.4F, 0.5F, noise2(x / 60, y / 60, seed + 5));
  const Eight tufts = grazingFractal(hits, 0.24F, 3, seed);
  const Eight fields = smoothstep(-0.2F, 0.2F, noise2(x / 37, y / 37, seed + 11));
  const Eight soil = fractal2(x, y, 5, 4, extent, seed + 9);
  return (0.11F + 0.08F * fields) *
         larger(1 + (0.5F + 0.7F * wild) * (1.7F * tufts + 0.5F * soil) + 0.5F * soil, 0.12F);
}

TOLMAN_INLINE Eight distances(const StreetPlan& plan, const Vec3s& points) {
  std::array<float, kLanes> result;
  for (int i = 0; i < kLanes; ++i) {
    result[static_cast<std::size_t>(i)] = static_cast<float>(
        plan.distance(static_cast<double>(points.x[i]), static_cast<double>(points.y[i])));
  }
  return loadEight(result.data());
}

TOLMAN_INLINE Eight land(const Surface& surface, const SurfaceHits& hits, const StreetPlan& plan) {
  const Eight distance = distances(plan, hits.point);
  const Eight extent = hits.footprint();
  constexpr auto kKerb = static_cast<float>(StreetPlan::kRoadHalfWidth);
  constexpr auto kPavement = static_cast<float>(StreetPlan::kPavementWidth);
  const Eight past_kerb = filteredStep(kKerb + 0.15F, distance, extent);
  const Eight past_pavement = filteredStep(kKerb + kPavement, distance, extent);
  Eight result = (1 - past_kerb) * 0.34F;  // the top of the kerb stones
  if (any(past_kerb > past_pavement)) {
    result += (past_kerb - past_pavement) * pavement(hits, distance, extent, surface.seed);
  }
  if (any(past_pavement > 0)) result += past_pavement * grass(hits, extent, surface.seed + 3);
  return result;
}

}  // namespace

TOLMAN_WIDE_LANES
void groundAlbedos(const Surface& surface, const SurfaceHits& hits, const StreetPlan& plan,
                   Eight& result) {
  switch (surface.material) {
    case Material::Road:
      result = road(surface, hits);
      break;
    case Material::Kerb:
      result = kerb(surface, hits);
      break;
    case Material::Paint:
      result = paint(surface, hits);
      break;
    default:
      result = land(surface, hits, plan);
  }
}

namespace {

bool isGround(const Surface& surface) {
  return surface.material == Material::Road || surface.material == Material::Paint ||
         surface.material == Material::Kerb || surface.material == Material::Land;
}

/// 1 in puddles, 0 on damp ground between them.
float puddle(const Vec3& point) {
  const float n = noise2(point.x / 2.7F, point.y / 2.7F, 911) +
                  0.4F * noise2(point.x / 0.8F, point.y / 0.8F, 912);
  return smoothstep(0.45F, 0.65F, n);
}

/// Share of the ground that snow covers; less in the tracks of cars.
float snowCover(const Surface& surface, const Vec3& point, const Vec3& normal,
                const StreetPlan& plan) {
  const float upwards = smoothstep(0.35F, 0.75F, normal.z);
  if (surface.material == Material::Leaves) return 0.75F * upwards;
  if (surface.material != Material::Road && surface.material != Material::Paint) return upwards;
  const auto from_centre = static_cast<float>(plan.distance(point.x, point.y));
  const float ragged = 0.08F * noise2(point.x / 1.1F, point.y / 1.1F, 921);
  const float from_track =
      std::abs(std::abs(from_centre - static_cast<float>(StreetPlan::kLaneOffset)) - 0.75F);
  return 0.1F + 0.85F * smoothstep(0.2F, 0.45F, from_track + ragged);
}

}  // namespace

float weatheredAlbedo(float dry, const Surface& surface, const Vec3& point, const Vec3& normal,
                      float footprint, const Light& light, const StreetPlan& plan) {
  float albedo = dry;
  if (light.wet > 0 && isGround(surface)) {
    albedo *= 1 - light.wet * (0.4F + 0.2F * puddle(point));
  }
  if (light.snow > 0) {
    const float crust = fractal2(point.x, point.y, 1.3F, 4, footprint, 931);
    const float drifts = noise2(point.x / 6, point.y / 6, 932);
    const float white = 0.72F * (1 + 0.12F * crust + 0.05F * drifts);
    albedo += light.snow * snowCover(surface, point, normal, plan) * (white - albedo);
  }
  return albedo;
}

}  // namespace tolman::town
