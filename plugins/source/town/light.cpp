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
  constexpr double kTownAxis = 30 * kDegree;
  return {static_cast<float>(std::cos(kTownAxis) * east - std::sin(kTownAxis) * north),
          static_cast<float>(std::sin(kTownAxis) * east + std::cos(kTownAxis) * north),
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

namespace {

// All chosen, not tuned.
constexpr float kLampReach = 30;  ///< m; also the size of the cells of the grid; bounds the time
constexpr float kIntensity = 9;   ///< m^2: 0.25 on the road 6 m below
constexpr float kHeadRadius = 0.55F;  ///< m about the middle of a lamp's head
constexpr float kBeam = 50;           ///< m^2, straight ahead
constexpr float kBeamWidth = 0.4F;    ///< rad to either side
constexpr float kBeamDepth = 0.08F;   ///< rad below the horizon

std::int64_t lampCellKey(std::int64_t column, std::int64_t row) { return column * 1'000'003 + row; }

std::int64_t lampCellOf(float coordinate) {
  return static_cast<std::int64_t>(std::floor(coordinate / kLampReach));
}

}  // namespace

StreetLamps::StreetLamps(const std::vector<Vec3>& heads) : heads_(heads) {
  for (std::uint32_t i = 0; i < heads.size(); ++i) {
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        cells_[lampCellKey(lampCellOf(heads[i].x) + dx, lampCellOf(heads[i].y) + dy)].push_back(i);
      }
    }
  }
}

const std::vector<std::uint32_t>* StreetLamps::near(const Vec3& point) const {
  const auto found = cells_.find(lampCellKey(lampCellOf(point.x), lampCellOf(point.y)));
  return found == cells_.end() ? nullptr : &found->second;
}

float StreetLamps::onto(const Vec3& point, const Vec3& n) const {
  const std::vector<std::uint32_t>* lamps = near(point);
  if (lamps == nullptr) return 0;
  float sum = 0;
  for (const std::uint32_t i : *lamps) {
    const Vec3 to_lamp = heads_[i] - point;
    const float squared = std::max(dot(to_lamp, to_lamp), 0.25F);
    if (squared > kLampReach * kLampReach) continue;
    const float distance = std::sqrt(squared);
    const float facing = std::max(0.0F, dot(n, to_lamp) / distance);
    const float downwards = smoothstep(-0.05F, 0.35F, to_lamp.z / distance);
    const float fade = 1 - smoothstep(0.6F * kLampReach, kLampReach, distance);
    sum += kIntensity * facing * downwards * fade / squared;
  }
  return sum;
}

bool StreetLamps::isHead(const Vec3& point) const {
  const std::vector<std::uint32_t>* lamps = near(point);
  return lamps != nullptr && std::any_of(lamps->begin(), lamps->end(), [&](std::uint32_t i) {
           const Vec3 away = point - heads_[i];
           return dot(away, away) < kHeadRadius * kHeadRadius;
         });
}

float headlightsOnto(const Headlights& beams, const Vec3& point, const Vec3& n) {
  const Vec3 ray = point - beams.from;
  const float distance = norm(ray);
  if (distance < 0.5F) return 0;
  const Vec3 way = ray * (1 / distance);
  const float ahead = dot(way, beams.ahead);
  if (ahead <= 0.2F) return 0;
  const Vec3 side = normalised(cross(beams.ahead, {0, 0, 1}));
  const float azimuth = dot(way, side) / ahead;
  const float above = way.z - beams.ahead.z;
  const float across = std::exp(-azimuth * azimuth / (kBeamWidth * kBeamWidth));
  const float below = above > 0 ? std::exp(-above / 0.015F) : std::exp(above / kBeamDepth);
  const float facing = std::max(0.0F, -dot(n, way));
  return kBeam * across * (0.03F + 0.97F * below) * facing / (distance * distance);
}

}  // namespace tolman::town
