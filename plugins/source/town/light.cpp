// SPDX-License-Identifier: BSD-3-Clause
#include "light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "noise.hpp"

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

/// The shares of reflected light (0.2 of sky, 0.25 of sun, halves of a quarter) are chosen, not
/// tuned.
float Light::onto(const Vec3& n, float lit) const {
  const float direct = lit * sun * std::max(0.0F, dot(n, to_sun));
  const float from_above = sky * (0.5F + 0.5F * n.z);
  const float from_ground = 0.25F * (0.2F * sky + 0.25F * sun) * (0.5F - 0.5F * n.z);
  // For walls of a street houses cover half of the sky.
  const float facing = 1 - 0.25F * (1 - std::abs(n.z));
  return direct + from_above * facing + from_ground;
}

/// Height of the clouds, their wavelength and contrast are chosen, not tuned.
float Light::fromSky(const Vec3& d, float spread) const {
  const float up = std::max(0.0F, d.z / norm(d));
  float radiance = horizon + (zenith - horizon) * std::sqrt(up);
  if (clouds > 0 && up > 0.01F) {
    const float height = 1 / (up + 0.12F);  // a flat layer of clouds, lower at the horizon
    const float n = fractal2(d.x / norm(d) * height, d.y / norm(d) * height, 1.6F, 4,
                             spread * height * height, seed);
    radiance *= 1 + clouds * smoothstep(-0.1F, 0.6F, n);
  }
  return radiance;
}

float Light::through(float of, float distance) const {
  if (haze <= 0) return of;
  const float clear = std::exp(-haze * distance);
  return horizon + (of - horizon) * clear;
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
