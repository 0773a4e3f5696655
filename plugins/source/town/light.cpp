// SPDX-License-Identifier: BSD-3-Clause
#include "light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "light_lanes.hpp"

namespace tolman::town {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Direction of the sun at 49 degrees north with a declination of 20 degrees (early summer).
Vec3 sunAt(double hour) {
  constexpr double kLatitude = 49 * kDegree;
  constexpr double kDeclination = 20 * kDegree;
  const double angle = (hour - 12) * 15 * kDegree;
  const double east = -std::cos(kDeclination) * std::sin(angle);
  const double north = std::cos(kLatitude) * std::sin(kDeclination) -
                       std::sin(kLatitude) * std::cos(kDeclination) * std::cos(angle);
  const double up = std::sin(kLatitude) * std::sin(kDeclination) +
                    std::cos(kLatitude) * std::cos(kDeclination) * std::cos(angle);
  // The town's Y axis points 30 degrees east of north, so that few streets are parallel to the
  // light.
  constexpr double kTurn = 30 * kDegree;
  return {static_cast<float>(std::cos(kTurn) * east - std::sin(kTurn) * north),
          static_cast<float>(std::sin(kTurn) * east + std::cos(kTurn) * north),
          static_cast<float>(up)};
}

}  // namespace

float Light::onto(const Vec3& n, float lit) const {
  return lightOnto(*this, vec3s(n), eight(lit))[0];
}

float Light::through(float of, float distance) const {
  return lightThrough(*this, eight(of), eight(distance))[0];
}

/// Radiances are in units of Light and chosen, not tuned; docs/town.md compares images of a clear
/// day with those of KITTI.
Light makeLight(double hour, Weather weather, double haze, std::uint32_t seed) {
  Light light;
  light.seed = seed;
  light.to_sun = sunAt(hour);
  light.haze = static_cast<float>(haze);
  const float day = smoothstep(-0.1F, 0.35F, light.to_sun.z);
  light.sun = 0.78F * smoothstep(0, 0.25F, light.to_sun.z);
  light.sky = 0.015F + 0.26F * day;
  if (weather != Weather::Clear) {
    light.sun = weather == Weather::Overcast ? 0.06F * light.sun : 0;
    light.sky *= 2;
    light.clouds = 0.12F;
    if (weather == Weather::Rain) light.haze += 0.003F;
    if (weather == Weather::Fog) light.haze += 0.02F;
  }
  light.horizon = 1.6F * light.sky + 0.05F * light.sun;
  light.zenith = 0.55F * light.horizon;
  if (weather != Weather::Clear) light.zenith = light.horizon;
  return light;
}

void makeNight(Light& light) {
  constexpr float kSky = 0.003F;  // irradiance / pi; chosen, not tuned
  const float factor = kSky / light.sky;
  for (float* part : {&light.sky, &light.horizon, &light.zenith}) *part *= factor;
  light.sun = 0;
  light.lamps = 1;
  light.dimness = 15;  // chosen, not tuned
}

Light meanOf(std::span<const Light> lights) {
  Light mean = lights.front();
  if (lights.size() == 1) return mean;
  constexpr std::array kParts = {&Light::sun,    &Light::sky,  &Light::horizon, &Light::zenith,
                                 &Light::clouds, &Light::haze, &Light::lamps,   &Light::wet,
                                 &Light::rain,   &Light::snow, &Light::dimness};
  const float share = 1 / static_cast<float>(lights.size());
  for (float Light::*const part : kParts) {
    float sum = 0;
    for (const Light& light : lights) sum += light.*part;
    mean.*part = share * sum;
  }
  Vec3 to_sun = {0, 0, 0};
  for (const Light& light : lights) to_sun = to_sun + light.to_sun * (light.sun + 1e-3F);
  mean.to_sun = normalised(to_sun);
  return mean;
}

}  // namespace tolman::town
