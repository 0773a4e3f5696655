// SPDX-License-Identifier: BSD-3-Clause
#include "material_weather.hpp"

#include <algorithm>
#include <cmath>

#include "noise.hpp"

namespace tolman::town {
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
  if (light.puddles > 0 && surface.material == Material::Road) {
    albedo *= 1 - light.puddles * 0.55F * puddle(point);
  }
  if (light.snow > 0) {
    const float crust = fractal2(point.x, point.y, 1.3F, 4, footprint, 931);
    const float drifts = noise2(point.x / 6, point.y / 6, 932);
    const float white = 0.72F * (1 + 0.12F * crust + 0.05F * drifts);
    albedo += light.snow * snowCover(surface, point, normal, plan) * (white - albedo);
  }
  return albedo;
}

float mirroredShare(const Surface& surface, const Vec3& point, const Vec3& normal, const Vec3& way,
                    const Light& light) {
  if (!isGround(surface) || normal.z < 0.7F) return 0;
  const float cosine = std::clamp(-dot(way, normal), 0.0F, 1.0F);
  const float fresnel = 0.02F + 0.98F * std::pow(1 - cosine, 5.0F);  // Schlick, water
  if (light.wet > 0) return light.wet * fresnel * (0.12F + 0.78F * puddle(point));
  const bool has_puddles = light.puddles > 0 && surface.material == Material::Road;
  return has_puddles ? light.puddles * fresnel * 0.9F * puddle(point) : 0;
}

float mirroredByGlass(float glass, const Vec3& normal, const Vec3& way) {
  const float cosine = std::clamp(-dot(way, normal), 0.0F, 1.0F);
  return glass * (0.1F + 0.9F * std::pow(1 - cosine, 5.0F));  // Schlick, both sides of a pane
}

}  // namespace tolman::town
