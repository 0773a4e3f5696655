// SPDX-License-Identifier: BSD-3-Clause
// Four octaves of noise at once, for single points; textures are in noise_lanes.hpp.
#include "noise.hpp"

#include "dispatch.hpp"
#include "noise_lanes.hpp"

namespace tolman::town {
namespace {

using Four = float __attribute__((vector_size(16)));
using FourWords = std::uint32_t __attribute__((vector_size(16)));

}  // namespace

template <>
struct detail::WordsOf<Four> {
  using Type = FourWords;
};

namespace {

struct Octaves {
  Four scale;   ///< 1 / wavelength
  Four weight;  ///< amplitude times survives()
};

/// False if the footprint is too large for all octaves.
[[gnu::always_inline]] inline bool octavesOf(float wavelength, int octaves, float footprint,
                                             Octaves& result) {
  const float fine = 1 / wavelength;
  result.scale = Four{fine, 2 * fine, 4 * fine, 8 * fine};
  const Four amplitude = {0.55F, 0.385F, 0.2695F, 0.18865F};
  result.weight = Four{0, 0, 0, 0};
  for (int i = 0; i < octaves; ++i) {
    const float left = survives(1 / result.scale[i], footprint);
    if (left <= 0) return i > 0;
    result.weight[i] = amplitude[i] * left;
  }
  return true;
}

[[gnu::always_inline]] inline float sum(Four v) { return (v[0] + v[1]) + (v[2] + v[3]); }

constexpr FourWords kSteps = {0, 1, 2, 3};

}  // namespace

TOLMAN_TOWN_DISPATCH
float fractal2(float x, float y, float wavelength, int octaves, float footprint,
               std::uint32_t seed) {
  Octaves of;
  if (!octavesOf(wavelength, octaves, footprint, of)) return 0;
  const Four noise = detail::planeNoise(
      detail::cellsOf(x * of.scale), detail::cellsOf(y * of.scale), (kSteps + seed) * 0xcb1ab31fU);
  return sum(of.weight * noise);
}

}  // namespace tolman::town
