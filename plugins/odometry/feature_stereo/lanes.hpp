// SPDX-License-Identifier: BSD-3-Clause
// Four doubles at once, for functions that are TOLMAN_WIDE_LANES: one register of AVX2, two of
// SSE2. Whether such values pass between functions in registers depends on the processor that the
// caller is compiled for, so only pass them to functions that are inlined into the caller.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>

#include "wide_lanes.hpp"

namespace tolman::feature_stereo {

constexpr int kFour = 4;
using Four = double __attribute__((vector_size(32)));
using FourMask = std::int64_t __attribute__((vector_size(32)));

/// `count` of them. Code for AVX2 expects vectors at multiples of 32 bytes, while their type alone
/// demands 16 where the compiler's default is SSE2. So keep them in these, and lone ones after
/// these.
template <std::size_t count>
struct alignas(32) Fours {
  Four values[count];

  TOLMAN_INLINE Four& operator[](std::size_t i) { return values[i]; }
  TOLMAN_INLINE const Four& operator[](std::size_t i) const { return values[i]; }
};
using Four3 = Fours<3>;
using Four6 = Fours<6>;

/// A rotation and a translation as plain numbers.
struct PlainPose {
  double R[3][3];  ///< from the camera to the world
  double t[3];

  explicit PlainPose(const Eigen::Isometry3d& T) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) R[i][j] = T.linear()(i, j);
      t[i] = T.translation()(i);
    }
  }
};

TOLMAN_INLINE Four four(double value) { return Four{value, value, value, value}; }
TOLMAN_INLINE Four chosen(FourMask mask, Four a, Four b) { return mask ? a : b; }
TOLMAN_INLINE Four squareRoot(Four value) {
  return Four{std::sqrt(value[0]), std::sqrt(value[1]), std::sqrt(value[2]), std::sqrt(value[3])};
}
TOLMAN_INLINE double sumOf(Four value) { return (value[0] + value[1]) + (value[2] + value[3]); }
/// R' v.
TOLMAN_INLINE Four3 turnedBack(const PlainPose& pose, const Four3& v) {
  Four3 q;
  for (std::size_t i = 0; i < 3; ++i) {
    q[i] = pose.R[0][i] * v[0] + pose.R[1][i] * v[1] + pose.R[2][i] * v[2];
  }
  return q;
}
TOLMAN_INLINE Four dot(const Four3& a, const Four3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// A symmetric matrix, given as xx, xy, xz, yy, yz, zz, times a vector.
TOLMAN_INLINE Four3 product(const Four6& m, const Four3& v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[1] * v[0] + m[3] * v[1] + m[4] * v[2],
          m[2] * v[0] + m[4] * v[1] + m[5] * v[2]};
}
/// Inverse of a symmetric matrix given as xx, xy, xz, yy, yz, zz.
TOLMAN_INLINE Four6 inverseOf(const Four6& m) {
  const Four a = m[3] * m[5] - m[4] * m[4];
  const Four b = m[2] * m[4] - m[1] * m[5];
  const Four c = m[1] * m[4] - m[2] * m[3];
  const Four scale = 1.0 / (m[0] * a + m[1] * b + m[2] * c);
  return {a * scale,
          b * scale,
          c * scale,
          (m[0] * m[5] - m[2] * m[2]) * scale,
          (m[1] * m[2] - m[0] * m[4]) * scale,
          (m[0] * m[3] - m[1] * m[1]) * scale};
}

}  // namespace tolman::feature_stereo
