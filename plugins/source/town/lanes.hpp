// SPDX-License-Identifier: BSD-3-Clause
// Eight points, normals and colours at once, in functions that are TOLMAN_WIDE_LANES: all that
// takes them by value is inlined into these (eight_floats.hpp); others take references.
#pragma once

#include "eight_floats.hpp"
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

}  // namespace tolman::town
