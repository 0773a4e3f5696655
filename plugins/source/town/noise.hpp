// SPDX-License-Identifier: BSD-3-Clause
// Seeded value noise on a lattice, faded out where pixels are too coarse for its wavelength.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "vec3.hpp"

namespace tolman::town {

/// A well-mixed 32-bit hash (two multiply-xorshift rounds).
constexpr std::uint32_t hash(std::uint32_t x) {
  x ^= x >> 16U;
  x *= 0x7feb352dU;
  x ^= x >> 15U;
  x *= 0x846ca68bU;
  return x ^ (x >> 16U);
}
constexpr std::uint32_t hash(std::uint32_t x, std::uint32_t y) {
  return hash(x ^ hash(y + 0x9e3779b9U));
}
constexpr std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return hash(x, hash(y, z));
}
/// Hash to [0, 1).
constexpr float unit(std::uint32_t h) { return static_cast<float>(h >> 8U) * 0x1.0p-24F; }
/// Hash to [low, high).
constexpr float between(std::uint32_t h, float low, float high) {
  return low + (high - low) * unit(h);
}

inline float smoothstep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

namespace detail {
struct NoiseCell {
  std::uint32_t index;
  float fade;
};
/// floor() by conversion: std::floor is a call on baseline x86-64.
inline NoiseCell cellOf(float x) {
  auto i = static_cast<std::int32_t>(x);
  if (static_cast<float>(i) > x) --i;
  const float f = x - static_cast<float>(i);
  return {static_cast<std::uint32_t>(i), f * f * (3 - 2 * f)};
}
/// Lattice value in [-1, 1). Only one round of hashing, because this is the inner loop of all
/// textures.
inline float lattice(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  std::uint32_t h = x * 0x8da6b343U ^ y * 0xd8163841U ^ z * 0xcb1ab31fU;
  h = (h ^ (h >> 15U)) * 0x846ca68bU;
  h ^= h >> 13U;
  return static_cast<float>(static_cast<std::int32_t>(h)) * 0x1.0p-31F;
}
inline float mix(float a, float b, float t) { return a + (b - a) * t; }
}  // namespace detail

/// Noise in [-1, 1] with lattice cells of 1.
inline float noise2(float x, float y, std::uint32_t seed) {
  const auto [ix, fx] = detail::cellOf(x);
  const auto [iy, fy] = detail::cellOf(y);
  return detail::mix(
      detail::mix(detail::lattice(ix, iy, seed), detail::lattice(ix + 1, iy, seed), fx),
      detail::mix(detail::lattice(ix, iy + 1, seed), detail::lattice(ix + 1, iy + 1, seed), fx),
      fy);
}

inline float noise3(const Vec3& p, std::uint32_t seed) {
  const auto [iz, fz] = detail::cellOf(p.z);
  const auto plane = [&](std::uint32_t z) { return noise2(p.x, p.y, seed + z * 0x68bc21ebU); };
  return detail::mix(plane(iz), plane(iz + 1), fz);
}

/// Factor of the amplitude of a wavelength (m) in a pixel that covers `footprint` m: 1 for much
/// longer waves, 0 at and below the sampling limit. It avoids aliasing of textures.
inline float survives(float wavelength, float footprint) {
  return smoothstep(1.5F, 4.0F, wavelength / std::max(footprint, 1e-6F));
}

/// Sum of at most four octaves of noise2, the first of `wavelength` (m), each faded by `footprint`;
/// in about [-1, 1].
inline float fractal2(float x, float y, float wavelength, int octaves, float footprint,
                      std::uint32_t seed) {
  constexpr float kAmplitudes[] = {0.55F, 0.385F, 0.2695F, 0.18865F};
  float terms[4] = {};
  float scale = 1 / wavelength;
  for (int i = 0; i < octaves; ++i, scale *= 2) {
    const float weight = kAmplitudes[i] * survives(1 / scale, footprint);
    if (weight <= 0) break;
    terms[i] = weight * noise2(x * scale, y * scale, seed + static_cast<std::uint32_t>(i));
  }
  return (terms[0] + terms[1]) + (terms[2] + terms[3]);
}

}  // namespace tolman::town
