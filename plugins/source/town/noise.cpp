// SPDX-License-Identifier: BSD-3-Clause
// Four octaves, or four points, of noise at once: the inner loop of every texture.
#include "noise.hpp"

#include "dispatch.hpp"

namespace tolman::town {
namespace {

using Floats = float __attribute__((vector_size(16)));
using Words = std::uint32_t __attribute__((vector_size(16)));
using Integers = std::int32_t __attribute__((vector_size(16)));

struct NoiseCells {
  Words index;
  Floats fade;
};

[[gnu::always_inline]] inline NoiseCells cellsOf(Floats x) {
  Integers i = __builtin_convertvector(x, Integers);
  i += __builtin_convertvector(i, Floats) > x;  // a true lane is -1
  const Floats f = x - __builtin_convertvector(i, Floats);
  return {reinterpret_cast<Words>(i), f * f * (3 - 2 * f)};
}

/// detail::lattice of each lane, from the products with its constants.
[[gnu::always_inline]] inline Floats latticeOf(Words h) {
  h = (h ^ (h >> 15)) * 0x846ca68bU;
  h ^= h >> 13;
  return __builtin_convertvector(reinterpret_cast<Integers>(h), Floats) * 0x1.0p-31F;
}

[[gnu::always_inline]] inline Floats noiseLanes(Floats x, Floats y, Words seed) {
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

[[gnu::always_inline]] inline Floats noiseLanes3(const Vec3& p, Floats scale, Words seed) {
  const NoiseCells cz = cellsOf(p.z * scale);
  const Words base = seed + cz.index * 0x68bc21ebU;
  const Floats x = p.x * scale;
  const Floats y = p.y * scale;
  const Floats low = noiseLanes(x, y, base);
  const Floats high = noiseLanes(x, y, base + 0x68bc21ebU);
  return low + (high - low) * cz.fade;
}

struct Octaves {
  Floats scale;   ///< 1 / wavelength
  Floats weight;  ///< amplitude times survives()
};

/// False if the footprint is too large for all octaves.
[[gnu::always_inline]] inline bool octavesOf(float wavelength, int octaves, float footprint,
                                             Octaves& result) {
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

[[gnu::always_inline]] inline float sum(Floats v) { return (v[0] + v[1]) + (v[2] + v[3]); }

constexpr Words kSteps = {0, 1, 2, 3};

}  // namespace

TOLMAN_TOWN_DISPATCH
float fractal2(float x, float y, float wavelength, int octaves, float footprint,
               std::uint32_t seed) {
  Octaves of;
  if (!octavesOf(wavelength, octaves, footprint, of)) return 0;
  return sum(of.weight * noiseLanes(x * of.scale, y * of.scale, kSteps + seed));
}

TOLMAN_TOWN_DISPATCH
float fractal3(const Vec3& p, float wavelength, int octaves, float footprint, std::uint32_t seed) {
  Octaves of;
  if (!octavesOf(wavelength, octaves, footprint, of)) return 0;
  return sum(of.weight * noiseLanes3(p, of.scale, kSteps + seed));
}

TOLMAN_TOWN_DISPATCH
std::array<float, 4> layers3(const Vec3& p, float wavelength, float footprint, std::uint32_t seed) {
  const float scale = 1 / wavelength;
  const Floats n = noiseLanes3(p, Floats{scale, 4 * scale, 16 * scale, 64 * scale}, kSteps + seed);
  std::array<float, 4> layers{};
  for (std::size_t i = 0; i < 4; ++i, wavelength *= 0.25F) {
    layers[i] = n[i] * survives(wavelength, footprint);
  }
  return layers;
}

TOLMAN_TOWN_DISPATCH
float meanNoise2(float x, float y, float dx, float dy, int taps, std::uint32_t seed) {
  const Floats steps = {0, 1, 2, 3};
  const Words seeds = {seed, seed, seed, seed};
  const Floats n = noiseLanes(x + dx * steps, y + dy * steps, seeds);
  float total = 0;
  for (int i = 0; i < taps; ++i) total += n[i];
  return total / static_cast<float>(taps);
}

}  // namespace tolman::town
