// SPDX-License-Identifier: BSD-3-Clause
// Light on eight points at once.
#pragma once

#include "light.hpp"
#include "noise_lanes.hpp"

namespace tolman::town {

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
