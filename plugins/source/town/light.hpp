// SPDX-License-Identifier: BSD-3-Clause
// Sun, sky and air; street lamps and headlights at night, which cast no shadows.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "lanes.hpp"
#include "vec3.hpp"

namespace tolman::town {

enum class Weather : std::uint8_t { Clear, Overcast, Rain };

/// Low beams of the car itself.
struct Headlights {
  Vec3 from;               ///< town axes
  Vec3 ahead = {0, 1, 0};  ///< unit vector
};

/// Radiances are relative: a white surface under a high, clear sun gives about 1.
struct Light {
  Vec3 to_sun = {0, 0, 1};  ///< unit vector, town axes
  float sun = 0.8F;         ///< irradiance / pi of a surface that faces the sun
  float sky = 0.2F;         ///< the same of an upward surface in the shade
  float horizon = 0.4F;     ///< radiance of the sky near the horizon
  float zenith = 0.25F;
  float clouds = 0.3F;  ///< contrast of clouds
  float haze = 0;       ///< extinction, 1/m
  std::uint32_t seed = 0;
  // Night and weather, 0 for none and 1 for full.
  float lamps = 0;  ///< street lamps, lit windows and headlights
  float wet = 0;    ///< wetness of the ground
  float rain = 0;   ///< drops in the air
  float snow = 0;   ///< cover of surfaces that face upwards
  Headlights headlights;
  /// Factor from the real light to these radiances, larger at night. Cameras compensate for it by
  /// longer exposure and amplification.
  float dimness = 1;

  /// Diffuse light on a surface with unit normal `n`, of which the share `lit` sees the sun.
  float onto(const Vec3& n, float lit) const;
  /// Radiance `of` a point seen through `distance` m of air.
  float through(float of, float distance) const;
  /// Light that determines the exposure: that on the road, and more with snow, which reflects more.
  float level() const { return (onto({0, 0, 1}, 1) + 0.09F * lamps) * (1 + 1.3F * snow); }
};

/// Light at `hour` of a summer day at 49 degrees north, 0 to 24; at night only that of the sky.
Light makeLight(double hour, Weather weather, double haze, std::uint32_t seed);

/// Changes the light to a dark sky with lamps on.
void makeNight(Light& light);

/// The mean of all values, with a mean direction of the sun.
Light meanOf(std::span<const Light> lights);

class StreetLamps {
 public:
  StreetLamps() = default;
  explicit StreetLamps(const std::vector<Vec3>& heads);

  /// Irradiance / pi at a point with unit normal `n`.
  float onto(const Vec3& point, const Vec3& n) const;
  /// Whether the point is on the head of a lamp, which emits light.
  bool isHead(const Vec3& point) const;

 private:
  const std::vector<std::uint32_t>* near(const Vec3& point) const;

  std::vector<Vec3> heads_;
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_;
};

/// Low beams: bright below the horizon straight ahead.
float headlightsOnto(const Headlights& beams, const Vec3& point, const Vec3& n);

/// Diffuse light on surfaces with unit normals `n`, of which the shares `lit` see the sun.
///
/// The shares of reflected light (0.2 of sky, 0.25 of sun, halves of a quarter) are chosen, not
/// tuned.
TOLMAN_INLINE Eight lightOnto(const Light& light, const Vec3s& n, Eight lit) {
  const Eight direct = lit * light.sun * larger(dot(n, vec3s(light.to_sun)), 0);
  const Eight from_above = light.sky * (0.5F + 0.5F * n.z);
  const Eight from_ground = 0.25F * (0.2F * light.sky + 0.25F * light.sun) * (0.5F - 0.5F * n.z);
  // For walls of a street houses cover half of the sky.
  const Eight facing = 1 - 0.25F * (1 - absolute(n.z));
  return direct + from_above * facing + from_ground;
}

/// Radiance of the sky from directions `d` (any length), averaged over `spread` rad.
///
/// Height of the clouds, their wavelength and contrast are chosen, not tuned.
TOLMAN_INLINE Eight lightFromSky(const Light& light, const Vec3s& d, float spread) {
  const Eight length = norm(d);
  const Eight up = larger(d.z / length, 0);
  const Eight clear = light.horizon + (light.zenith - light.horizon) * squareRoot(up);
  const EightInts cloudy = up > 0.01F;
  if (light.clouds <= 0 || !any(cloudy)) return clear;
  const Eight height = 1 / (up + 0.12F);  // a flat layer of clouds, lower at the horizon
  const Eight n = fractal2(d.x / length * height, d.y / length * height, 1.6F, 4,
                           spread * height * height, light.seed);
  return select(cloudy, clear * (1 + light.clouds * smoothstep(-0.1F, 0.6F, n)), clear);
}

/// Radiances `of` points seen through `distance` m of air.
TOLMAN_INLINE Eight lightThrough(const Light& light, Eight of, Eight distance) {
  if (light.haze <= 0) return of;
  return light.horizon + (of - light.horizon) * exponential(-light.haze * distance);
}

}  // namespace tolman::town
