// SPDX-License-Identifier: BSD-3-Clause
// Asphalt, kerbs, paint, pavement and grass. Patterns are functions of the town's X and Y.
#include "dispatch.hpp"
#include "material.hpp"
#include "noise.hpp"
#include "pattern.hpp"

namespace tolman::town {
namespace {

/// Octaves of noise for a long, narrow footprint, as in grazing views: the mean of samples along
/// the longer side, each faded by the shorter one.
float grazingFractal(const SurfaceHit& hit, float wavelength, int octaves, std::uint32_t seed) {
  const bool along_dy = dot(hit.dy, hit.dy) > dot(hit.dx, hit.dx);
  const Vec3& major = along_dy ? hit.dy : hit.dx;
  const float longer = norm(major);
  const float shorter = std::max(norm(along_dy ? hit.dx : hit.dy), longer * 0.25F);
  float sum = 0;
  float amplitude = 0.55F;
  for (int i = 0; i < octaves; ++i, wavelength *= 0.5F, amplitude *= 0.8F) {
    const float weight = amplitude * survives(wavelength, shorter);
    if (weight <= 0) break;
    const int taps = std::clamp(static_cast<int>(std::ceil(2.5F * longer / wavelength)), 1, 4);
    const float scale = 1 / wavelength;
    const Vec3 step = major * (scale / static_cast<float>(taps));
    const Vec3 first = hit.point * scale - step * (0.5F * static_cast<float>(taps - 1));
    sum += weight *
           meanNoise2(first.x, first.y, step.x, step.y, taps, seed + static_cast<std::uint32_t>(i));
  }
  return sum;
}

/// Repaired rectangles, darker or lighter than the rest, with a tarred seam.
float patches(const SurfaceHit& hit, std::uint32_t seed) {
  constexpr float kCell = 9;  // m
  const auto cx = static_cast<std::int32_t>(floorOf(hit.point.x / kCell));
  const auto cy = static_cast<std::int32_t>(floorOf(hit.point.y / kCell));
  const std::uint32_t h =
      hash(static_cast<std::uint32_t>(cx), static_cast<std::uint32_t>(cy), seed);
  if (unit(h) > 0.45F) return 0;
  const float x = hit.point.x - static_cast<float>(cx) * kCell;
  const float y = hit.point.y - static_cast<float>(cy) * kCell;
  const float left = between(hash(h, 1), 0.5F, 5);
  const float low = between(hash(h, 2), 0.5F, 5);
  const float right = left + between(hash(h, 3), 0.6F, 3.5F);
  const float high = low + between(hash(h, 4), 0.6F, 3.5F);
  const float ex = hit.extent({1, 0, 0});
  const float ey = hit.extent({0, 1, 0});
  const float outer = filteredPulse(left, right, x, ex) * filteredPulse(low, high, y, ey);
  const float inner = filteredPulse(left + 0.06F, right - 0.06F, x, ex) *
                      filteredPulse(low + 0.06F, high - 0.06F, y, ey);
  return inner * between(hash(h, 5), -0.35F, 0.25F) - (outer - inner) * 0.5F;
}

/// Thin dark lines where smooth noise crosses zero.
float cracks(const SurfaceHit& hit, std::uint32_t seed) {
  constexpr float kWidth = 0.012F;  // m
  const float width = kWidth + 0.7F * hit.footprint();
  if (kWidth / width < 0.08F) return 0;  // too thin for this pixel
  const float n = noise2(hit.point.x / 2.3F, hit.point.y / 2.3F, seed);
  // |n| / slope is about the distance to the line; the mean slope is 0.5 a metre.
  const float distance = std::abs(n) / 0.5F;
  return kWidth / width * (1 - smoothstep(0.5F * width, 1.5F * width, distance));
}

float road(const Surface& surface, const SurfaceHit& hit) {
  const float grain = grazingFractal(hit, 0.05F, 2, surface.seed);
  const float wear = fractal2(hit.point.x, hit.point.y, 7, 3, hit.footprint(), surface.seed + 17);
  const float detail = 0.85F * grain + 0.25F * wear + patches(hit, surface.seed + 31) -
                       0.6F * cracks(hit, surface.seed + 47);
  return surface.tone * std::max(0.15F, 1 + detail);
}

float kerb(const Surface& surface, const SurfaceHit& hit) {
  const float along = hit.point.x + hit.point.y;  // stones of about 1 m for any heading of the kerb
  const float joints = filteredStripes(1, 0.03F, along, hit.extent({1, 1, 0}));
  const float stain = fractal2(hit.point.x, hit.point.y, 0.8F, 3, hit.footprint(), surface.seed);
  return surface.tone * std::max(0.2F, 1 + 0.35F * stain - 0.6F * joints);
}

float paint(const Surface& surface, const SurfaceHit& hit) {
  const float worn = grazingFractal(hit, 0.3F, 3, surface.seed);
  return surface.tone * (1 + 0.3F * worn);
}

/// Slabs in rows that follow the kerb.
float pavement(const SurfaceHit& hit, float distance, float extent, std::uint32_t seed) {
  const float rows = filteredStripes(0.4F, 0.025F, distance, extent);
  const float across =
      filteredStripes(0.4F, 0.025F, hit.point.x + 0.37F * hit.point.y, hit.extent({1, 0.37F, 0}));
  const float slabs = fractal2(hit.point.x, hit.point.y, 0.9F, 4, hit.footprint(), seed);
  return 0.27F * std::max(0.2F, 1 + 0.7F * slabs - 0.45F * std::max(rows, across));
}

float grass(const SurfaceHit& hit, std::uint32_t seed) {
  // Mown lawns have little texture, meadows much; it changes over 60 m.
  const float wild = smoothstep(-0.4F, 0.5F, noise2(hit.point.x / 60, hit.point.y / 60, seed + 5));
  const float tufts = grazingFractal(hit, 0.24F, 3, seed);
  const float fields =
      smoothstep(-0.2F, 0.2F, noise2(hit.point.x / 37, hit.point.y / 37, seed + 11));
  const float soil = fractal2(hit.point.x, hit.point.y, 5, 4, hit.footprint(), seed + 9);
  return (0.11F + 0.08F * fields) *
         std::max(0.12F, 1 + (0.5F + 0.7F * wild) * (1.7F * tufts + 0.5F * soil) + 0.5F * soil);
}

float land(const Surface& surface, const SurfaceHit& hit, const StreetPlan& plan) {
  const auto distance = static_cast<float>(plan.distance(hit.point.x, hit.point.y));
  const float extent = hit.footprint();
  constexpr auto kKerb = static_cast<float>(StreetPlan::kRoadHalfWidth);
  constexpr auto kPavement = static_cast<float>(StreetPlan::kPavementWidth);
  const float past_kerb = filteredStep(kKerb + 0.15F, distance, extent);
  const float past_pavement = filteredStep(kKerb + kPavement, distance, extent);
  float result = 0;
  if (past_kerb < 1) result += (1 - past_kerb) * 0.34F;  // the top of the kerb stones
  if (past_kerb > past_pavement) {
    result += (past_kerb - past_pavement) * pavement(hit, distance, extent, surface.seed);
  }
  if (past_pavement > 0) result += past_pavement * grass(hit, surface.seed + 3);
  return result;
}

}  // namespace

TOLMAN_TOWN_DISPATCH [[gnu::flatten]] float groundAlbedo(const Surface& surface,
                                                         const SurfaceHit& hit,
                                                         const StreetPlan& plan) {
  switch (surface.material) {
    case Material::Road:
      return road(surface, hit);
    case Material::Kerb:
      return kerb(surface, hit);
    case Material::Paint:
      return paint(surface, hit);
    default:
      return land(surface, hit, plan);
  }
}

}  // namespace tolman::town
