// SPDX-License-Identifier: BSD-3-Clause
// Four octaves of noise at once, for single points; textures are in noise_lanes.hpp.
#include "noise.hpp"

#include "four_floats.hpp"

namespace tolman::town {
namespace {

using Floats = lanes::FourFloats;
using Words = lanes::FourWords;

struct NoiseCells {
  Words index;
  Floats fade;
};

TOLMAN_INLINE NoiseCells cellsOf(Floats x) {
  lanes::FourInts i = lanes::truncated(x);
  i += lanes::toFloat(i) > x;  // a true lane is -1
  const Floats f = x - lanes::toFloat(i);
  return {lanes::words(i), f * f * (3 - 2 * f)};
}

/// detail::lattice of each lane, from the products with its constants.
TOLMAN_INLINE Floats latticeOf(Words h) {
  h = (h ^ (h >> 15)) * 0x846ca68bU;
  h ^= h >> 13;
  return lanes::toFloat(reinterpret_cast<lanes::FourInts>(h)) * 0x1.0p-31F;
}

TOLMAN_INLINE Floats noiseLanes(Floats x, Floats y, Words seed) {
  const NoiseCells cx = cellsOf(x);
  const NoiseCells cy = cellsOf(y);
  const Words x0 = cx.index * 0x8da6b343U;
  const Words x1 = x0 + 0x8da6b343U;
  const Words z = seed * 0xcb1ab31fU;
  const Words y0 = cy.index * 0xd8163841U ^ z;
  const Words y1 = (cy.index + 1) * 0xd8163841U ^ z;
  const Floats a = latticeOf(x0 ^ y0);
  const Floats b = latticeOf(x1 ^ y0);
  const Floats c = latticeOf(x0 ^ y1);
  const Floats d = latticeOf(x1 ^ y1);
  const Floats low = a + (b - a) * cx.fade;
  const Floats high = c + (d - c) * cx.fade;
  return low + (high - low) * cy.fade;
}

struct Octaves {
  Floats scale;   ///< 1 / wavelength
  Floats weight;  ///< amplitude times survives()
};

/// False if the footprint is too large for all octaves.
TOLMAN_INLINE bool octavesOf(float wavelength, int octaves, float footprint, Octaves& result) {
  const float fine = 1 / wavelength;
  result.scale = Floats{fine, 2 * fine, 4 * fine, 8 * fine};
  const Floats amplitude = {0.55F, 0.385F, 0.2695F, 0.18865F};
  result.weight = Floats{0, 0, 0, 0};
  for (int i = 0; i < octaves; ++i) {
    const float left = survives(1 / result.scale[i], footprint);
    if (left <= 0) return i > 0;
    result.weight[i] = amplitude[i] * left;
  }
  return true;
}

constexpr Words kSteps = {0, 1, 2, 3};

}  // namespace

TOLMAN_WIDE_LANES
float fractal2(float x, float y, float wavelength, int octaves, float footprint,
               std::uint32_t seed) {
  Octaves of;
  if (!octavesOf(wavelength, octaves, footprint, of)) return 0;
  return lanes::sumOf(of.weight * noiseLanes(x * of.scale, y * of.scale, kSteps + seed));
}

}  // namespace tolman::town
