// SPDX-License-Identifier: BSD-3-Clause
// Eight points, normals and colours at once, in functions that are TOLMAN_WIDE_LANES: all that
// takes them by value is inlined into these (eight_floats.hpp); others take references. The noise
// of noise.hpp and box-filtered patterns: the inner loops of every texture.
#pragma once

#include <array>

#include "eight_floats.hpp"
#include "noise.hpp"
#include "vec3.hpp"

namespace tolman::town {

inline constexpr int kLanes = 8;

using namespace lanes;
using lanes::floorOf;  // beside those of numbers and of vectors
using lanes::select;
using Eight = EightFloats;

/// e^x for x <= 0, to 1e-7 of the value: a power of two times a polynomial.
TOLMAN_INLINE Eight exponential(Eight x) {
  x = larger(x, -80.0F);
  const Eight n = floorOf(x * 1.44269504F + 0.5F);
  const Eight r = (x - n * 0.693359375F) + n * 2.12194440e-4F;
  Eight p = 1.9875691500e-4F * r + 1.3981999507e-3F;
  p = p * r + 8.3334519073e-3F;
  p = p * r + 4.1665795894e-2F;
  p = p * r + 1.6666665459e-1F;
  p = p * r + 5.0000001201e-1F;
  const EightInts exponent = (truncated(n) + 127) << 23;
  return (p * r * r + r + 1) * reinterpret_cast<Eight>(exponent);
}

TOLMAN_INLINE Eight smoothstep(float low, float high, Eight x) {
  const Eight t = clamped((x - low) / (high - low), 0, 1);
  return t * t * (3 - 2 * t);
}

/// Eight vectors.
struct Vec3s {
  Eight x;
  Eight y;
  Eight z;
};

TOLMAN_INLINE Vec3s operator+(const Vec3s& a, const Vec3s& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
TOLMAN_INLINE Vec3s operator-(const Vec3s& a, const Vec3s& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
TOLMAN_INLINE Vec3s operator*(const Vec3s& a, Eight s) { return {a.x * s, a.y * s, a.z * s}; }
TOLMAN_INLINE Eight dot(const Vec3s& a, const Vec3s& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
TOLMAN_INLINE Eight norm(const Vec3s& a) { return squareRoot(dot(a, a)); }
TOLMAN_INLINE Vec3s normalised(const Vec3s& a) { return a * (1 / norm(a)); }
TOLMAN_INLINE Vec3s select(EightInts mask, const Vec3s& a, const Vec3s& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}
/// The same vector in all lanes.
TOLMAN_INLINE Vec3s vec3s(const Vec3& v) { return {eight(v.x), eight(v.y), eight(v.z)}; }
TOLMAN_INLINE Vec3 lane(const Vec3s& v, int i) { return {v.x[i], v.y[i], v.z[i]}; }

TOLMAN_INLINE EightWords hash(EightWords x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  return x ^ (x >> 16);
}
TOLMAN_INLINE EightWords hash(EightWords x, std::uint32_t y) {
  return hash(x ^ hash(y + 0x9e3779b9U));
}
TOLMAN_INLINE EightWords hash(EightWords x, EightWords y) {
  return hash(x ^ hash(y + 0x9e3779b9U));
}
TOLMAN_INLINE EightWords hash(EightWords x, EightWords y, std::uint32_t z) {
  return hash(x, hash(y, z));
}
TOLMAN_INLINE Eight unit(EightWords h) {
  return toFloat(reinterpret_cast<EightInts>(h >> 8)) * 0x1.0p-24F;
}
TOLMAN_INLINE Eight between(EightWords h, float low, float high) {
  return low + (high - low) * unit(h);
}

namespace detail {
struct NoiseCells {
  EightWords index;
  Eight fade;
};
TOLMAN_INLINE NoiseCells cellsOf(Eight x) {
  EightInts i = truncated(x);
  i += toFloat(i) > x;  // a true lane is -1
  const Eight f = x - toFloat(i);
  return {words(i), f * f * (3 - 2 * f)};
}
/// lattice() of each lane, from the combined products with its constants.
TOLMAN_INLINE Eight latticeOf(EightWords h) {
  h = (h ^ (h >> 15)) * 0x846ca68bU;
  h ^= h >> 13;
  return toFloat(reinterpret_cast<EightInts>(h)) * 0x1.0p-31F;
}
/// Noise in the plane of the cells; `z` is the seed times its constant.
template <class Word>
TOLMAN_INLINE Eight planeNoise(const NoiseCells& cx, const NoiseCells& cy, Word z) {
  const auto x0 = cx.index * 0x8da6b343U;
  const auto x1 = x0 + 0x8da6b343U;
  const auto y = cy.index * 0xd8163841U;
  const auto y0 = y ^ z;
  const auto y1 = (y + 0xd8163841U) ^ z;
  const auto a = latticeOf(x0 ^ y0);
  const auto b = latticeOf(x1 ^ y0);
  const auto c = latticeOf(x0 ^ y1);
  const auto d = latticeOf(x1 ^ y1);
  const Eight low = a + (b - a) * cx.fade;
  const Eight high = c + (d - c) * cx.fade;
  return low + (high - low) * cy.fade;
}
}  // namespace detail

template <class Seed>
TOLMAN_INLINE Eight noise2(Eight x, Eight y, Seed seed) {
  return detail::planeNoise(detail::cellsOf(x), detail::cellsOf(y), seed * 0xcb1ab31fU);
}

template <class Seed>
TOLMAN_INLINE Eight noise3(const Vec3s& p, Seed seed) {
  const detail::NoiseCells cx = detail::cellsOf(p.x);
  const detail::NoiseCells cy = detail::cellsOf(p.y);
  const detail::NoiseCells cz = detail::cellsOf(p.z);
  const EightWords plane = seed + cz.index * 0x68bc21ebU;
  const Eight low = detail::planeNoise(cx, cy, plane * 0xcb1ab31fU);
  const Eight high = detail::planeNoise(cx, cy, (plane + 0x68bc21ebU) * 0xcb1ab31fU);
  return low + (high - low) * cz.fade;
}

/// survives() of a wavelength that is `ratio` times the footprint.
TOLMAN_INLINE Eight survivesRatio(Eight ratio) { return smoothstep(1.5F, 4, ratio); }
TOLMAN_INLINE Eight survives(float wavelength, Eight footprint) {
  return survivesRatio(wavelength / larger(footprint, 1e-6F));
}

/// Sum of at most four octaves of noise(scale, seed), which is noise of the wavelength 1 / scale.
/// Ends at the first octave that no lane can resolve.
template <class Seed, class Noise>
TOLMAN_INLINE Eight sumOfOctaves(float wavelength, int octaves, Eight footprint, Seed seed,
                                 const Noise& noise) {
  constexpr std::array<float, 4> kAmplitudes = {0.55F, 0.385F, 0.2695F, 0.18865F};
  std::array<Eight, 4> terms = {};
  Eight ratio = wavelength / larger(footprint, 1e-6F);
  float scale = 1 / wavelength;
  for (int i = 0; i < octaves; ++i, ratio *= 0.5F, scale *= 2) {
    const Eight weight = survivesRatio(ratio);
    if (!any(weight > 0)) break;
    const auto k = static_cast<std::size_t>(i);
    terms[k] = kAmplitudes[k] * weight * noise(scale, seed + static_cast<std::uint32_t>(i));
  }
  return (terms[0] + terms[1]) + (terms[2] + terms[3]);
}

template <class Seed>
TOLMAN_INLINE Eight fractal2(Eight x, Eight y, float wavelength, int octaves, Eight footprint,
                             Seed seed) {
  return sumOfOctaves(wavelength, octaves, footprint, seed,
                      [&](float scale, Seed own)
                          TOLMAN_INLINE_LAMBDA { return noise2(x * scale, y * scale, own); });
}

template <class Seed>
TOLMAN_INLINE Eight fractal3(const Vec3s& p, float wavelength, int octaves, Eight footprint,
                             Seed seed) {
  return sumOfOctaves(wavelength, octaves, footprint, seed,
                      [&](float scale, Seed own)
                          TOLMAN_INLINE_LAMBDA { return noise3(p * eight(scale), own); });
}

/// Four layers of noise3, each wavelength a quarter of the one before, faded by `footprint`.
template <class Seed>
TOLMAN_INLINE std::array<Eight, 4> layers3(const Vec3s& p, float wavelength, Eight footprint,
                                           Seed seed) {
  std::array<Eight, 4> layers = {};
  float scale = 1 / wavelength;
  for (std::uint32_t i = 0; i < 4; ++i, wavelength *= 0.25F, scale *= 4) {
    const Eight left = survives(wavelength, footprint);
    if (!any(left > 0)) break;
    layers[i] = noise3(p * eight(scale), seed + i) * left;
  }
  return layers;
}

/// Mean of noise2 at `taps` points (one to four) from (x, y) on, (dx, dy) apart.
template <class Seed>
TOLMAN_INLINE Eight meanNoise2(Eight x, Eight y, Eight dx, Eight dy, Eight taps, Seed seed) {
  Eight total = {};
  for (int i = 0; i < 4; ++i) {
    const auto step = static_cast<float>(i);
    const EightInts counts = taps > step;
    if (!any(counts)) break;
    total += select(counts, noise2(x + dx * step, y + dy * step, seed), Eight{});
  }
  return total / taps;
}

/// Share of the interval [x - width/2, x + width/2] that is at or above `edge`.
TOLMAN_INLINE Eight filteredStep(Eight edge, Eight x, Eight width) {
  return clamped((x - edge) / larger(width, 1e-5F) + 0.5F, 0, 1);
}
TOLMAN_INLINE Eight filteredStep(float edge, Eight x, Eight width) {
  return filteredStep(eight(edge), x, width);
}
/// Share of the interval around x that is within [low, high].
TOLMAN_INLINE Eight filteredPulse(Eight low, Eight high, Eight x, Eight width) {
  return filteredStep(low, x, width) - filteredStep(high, x, width);
}
TOLMAN_INLINE Eight filteredPulse(float low, float high, Eight x, Eight width) {
  return filteredPulse(eight(low), eight(high), x, width);
}

/// Share of the interval around x covered by stripes [k period, k period + on], k any integer.
TOLMAN_INLINE Eight filteredStripes(float period, float on, Eight x, Eight width) {
  const Eight w = larger(width, 1e-5F);
  // Integral of the stripes from 0 to t.
  const auto covered = [&](Eight t) TOLMAN_INLINE_LAMBDA {
    const Eight cycles = floorOf(t / period);
    return cycles * on + smaller(t - cycles * period, on);
  };
  return (covered(x + w / 2) - covered(x - w / 2)) / w;
}

/// Mean over the interval around x of a function that is value(k) on [k period, (k + 1) period],
/// for intervals up to a period. value() takes eight cells k.
template <class Value>
TOLMAN_INLINE Eight filteredCells(float period, Eight x, Eight width, const Value& value) {
  const Eight k = floorOf(x / period + 0.5F);  // the nearest boundary
  const Eight above = filteredStep(k * period, x, width);
  const EightInts cell = truncated(k);
  return (1 - above) * value(cell - 1) + above * value(cell);
}

/// Fixed geometry has the identity.
struct Placements {
  alignas(32) std::array<float, kLanes> cosine, sine, scale, x, y, z;

  void set(std::size_t i, const Placement& p) {
    cosine[i] = p.cosine;
    sine[i] = p.sine;
    scale[i] = p.scale;
    x[i] = p.position.x;
    y[i] = p.position.y;
    z[i] = p.position.z;
  }
  TOLMAN_INLINE Vec3s rotate(const Vec3s& v) const {
    const Eight c = loadEight(cosine.data());
    const Eight s = loadEight(sine.data());
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
  }
  TOLMAN_INLINE Vec3s unrotate(const Vec3s& v) const {
    const Eight c = loadEight(cosine.data());
    const Eight s = loadEight(sine.data());
    return {c * v.x + s * v.y, c * v.y - s * v.x, v.z};
  }
  TOLMAN_INLINE Eight shrinking() const { return 1 / loadEight(scale.data()); }
  TOLMAN_INLINE Vec3s toLocal(const Vec3s& town) const {
    return unrotate(town - Vec3s{loadEight(x.data()), loadEight(y.data()), loadEight(z.data())}) *
           shrinking();
  }
};

}  // namespace tolman::town
