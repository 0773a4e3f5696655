// SPDX-License-Identifier: BSD-3-Clause
// Four octaves of noise at once, for single points; textures are in noise_lanes.hpp.
#include "noise.hpp"

#include "lanes.hpp"

namespace tolman::town {
namespace {

using Four = FourFloats;

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
TOLMAN_INLINE bool octavesOf(float wavelength, int octaves, float footprint, Octaves& result) {
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

constexpr FourWords kSteps = {0, 1, 2, 3};

}  // namespace

TOLMAN_WIDE_LANES
float fractal2(float x, float y, float wavelength, int octaves, float footprint,
               std::uint32_t seed) {
  Octaves of;
  if (!octavesOf(wavelength, octaves, footprint, of)) return 0;
  const Four noise = detail::planeNoise(
      detail::cellsOf(x * of.scale), detail::cellsOf(y * of.scale), (kSteps + seed) * 0xcb1ab31fU);
  return sumOf(of.weight * noise);
}

}  // namespace tolman::town
