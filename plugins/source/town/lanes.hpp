// SPDX-License-Identifier: BSD-3-Clause
// Eight numbers at once, for functions that are TOLMAN_TOWN_DISPATCH: one register of AVX2, two of
// SSE2. Whether such values pass between functions in registers depends on the processor that the
// caller is compiled for, so all that takes them by value is inlined; others take references.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "vec3.hpp"

/// For functions of lanes: inlined into both versions of their caller.
#define TOLMAN_TOWN_INLINE inline __attribute__((always_inline))
#define TOLMAN_TOWN_INLINE_LAMBDA __attribute__((always_inline))

namespace tolman::town {

inline constexpr int kLanes = 8;

using Eight = float __attribute__((vector_size(32)));
using EightWords = std::uint32_t __attribute__((vector_size(32)));
using EightInts = std::int32_t __attribute__((vector_size(32)));  ///< masks, too: -1 is true

TOLMAN_TOWN_INLINE Eight eight(float value) { return value - Eight{}; }
TOLMAN_TOWN_INLINE Eight loadEight(const float* p) {
  Eight value;
  std::memcpy(&value, p, sizeof value);
  return value;
}
TOLMAN_TOWN_INLINE void store(Eight value, float* p) { std::memcpy(p, &value, sizeof value); }
TOLMAN_TOWN_INLINE Eight toFloat(EightInts v) { return __builtin_convertvector(v, Eight); }
TOLMAN_TOWN_INLINE EightInts truncated(Eight v) { return __builtin_convertvector(v, EightInts); }
TOLMAN_TOWN_INLINE EightWords words(EightInts v) { return reinterpret_cast<EightWords>(v); }

/// Whether any lane of a mask is true, and whether all are.
TOLMAN_TOWN_INLINE bool any(EightInts mask) {
  std::array<std::uint64_t, 4> parts;
  std::memcpy(parts.data(), &mask, sizeof mask);
  return ((parts[0] | parts[1]) | (parts[2] | parts[3])) != 0;
}
TOLMAN_TOWN_INLINE bool all(EightInts mask) { return !any(~mask); }

// Written so that one instruction of SSE computes each.
TOLMAN_TOWN_INLINE Eight larger(Eight a, Eight b) { return a > b ? a : b; }
TOLMAN_TOWN_INLINE Eight smaller(Eight a, Eight b) { return a < b ? a : b; }
TOLMAN_TOWN_INLINE Eight larger(Eight a, float b) { return larger(a, eight(b)); }
TOLMAN_TOWN_INLINE Eight smaller(Eight a, float b) { return smaller(a, eight(b)); }
TOLMAN_TOWN_INLINE Eight clamped(Eight v, float low, float high) {
  return smaller(larger(v, low), high);
}
TOLMAN_TOWN_INLINE Eight absolute(Eight v) {
  return reinterpret_cast<Eight>(reinterpret_cast<EightWords>(v) & 0x7fffffffU);
}
TOLMAN_TOWN_INLINE Eight select(EightInts mask, Eight a, Eight b) { return mask ? a : b; }
TOLMAN_TOWN_INLINE Eight select(EightInts mask, float a, float b) {
  return mask ? eight(a) : eight(b);
}

/// A loop over memory, because the vector extension has no square root.
TOLMAN_TOWN_INLINE Eight squareRoot(Eight v) {
  alignas(32) std::array<float, kLanes> lanes;
  std::memcpy(lanes.data(), &v, sizeof v);
  for (float& lane : lanes) lane = std::sqrt(lane);
  std::memcpy(&v, lanes.data(), sizeof v);
  return v;
}

/// Right for |x| < 2^31.
TOLMAN_TOWN_INLINE Eight floorOf(Eight x) {
  const Eight t = toFloat(truncated(x));
  return t > x ? t - 1 : t;
}

/// e^x for x <= 0, to 1e-7 of the value: a power of two times a polynomial.
TOLMAN_TOWN_INLINE Eight exponential(Eight x) {
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

TOLMAN_TOWN_INLINE Eight smoothstep(float low, float high, Eight x) {
  const Eight t = clamped((x - low) / (high - low), 0, 1);
  return t * t * (3 - 2 * t);
}

/// Eight vectors.
struct Vec3s {
  Eight x;
  Eight y;
  Eight z;
};

TOLMAN_TOWN_INLINE Vec3s operator+(const Vec3s& a, const Vec3s& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
TOLMAN_TOWN_INLINE Vec3s operator-(const Vec3s& a, const Vec3s& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
TOLMAN_TOWN_INLINE Vec3s operator*(const Vec3s& a, Eight s) { return {a.x * s, a.y * s, a.z * s}; }
TOLMAN_TOWN_INLINE Eight dot(const Vec3s& a, const Vec3s& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
TOLMAN_TOWN_INLINE Eight norm(const Vec3s& a) { return squareRoot(dot(a, a)); }
TOLMAN_TOWN_INLINE Vec3s normalised(const Vec3s& a) { return a * (1 / norm(a)); }
TOLMAN_TOWN_INLINE Vec3s select(EightInts mask, const Vec3s& a, const Vec3s& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}
/// The same vector in all lanes.
TOLMAN_TOWN_INLINE Vec3s vec3s(const Vec3& v) { return {eight(v.x), eight(v.y), eight(v.z)}; }
TOLMAN_TOWN_INLINE Vec3 lane(const Vec3s& v, int i) { return {v.x[i], v.y[i], v.z[i]}; }

}  // namespace tolman::town
