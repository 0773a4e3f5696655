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

  /// Diffuse light on a surface with unit normal `n`, of which the share `lit` sees the sun.
  float onto(const Vec3& n, float lit) const;
  /// Radiance from direction `d` (any length), averaged over `spread` rad.
  float fromSky(const Vec3& d, float spread) const;
  /// Radiance `of` a point seen through `distance` m of air.
  float through(float of, float distance) const;
};

/// `hour` of a summer day at 49 degrees north, 0 to 24; night is lit by the sky alone.
Light makeLight(double hour, Weather weather, double haze, std::uint32_t seed);

}  // namespace tolman::town
