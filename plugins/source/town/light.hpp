// SPDX-License-Identifier: BSD-3-Clause
// Sun, sky and air.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "vec3.hpp"

namespace tolman::town {

enum class Weather : std::uint8_t { Clear, Overcast, Rain, Fog };
inline constexpr std::array<std::string_view, 4> kWeatherNames = {"clear", "overcast", "rain",
                                                                  "fog"};
constexpr std::span<const std::string_view> enumNames(Weather) { return kWeatherNames; }

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
  /// Headlights of moving cars near the camera, the nearest first.
  static constexpr int kMaxOncoming = 4;
  std::array<Headlights, kMaxOncoming> oncoming;
  int oncoming_count = 0;
  float glass = 0;    ///< share of light that windows mirror beside clean glass
  float puddles = 0;  ///< on dry streets
  float wind = 0;     ///< m/s, moves leaves
  float seconds = 0;  ///< since the start of the drive
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

}  // namespace tolman::town
