// SPDX-License-Identifier: BSD-3-Clause
// Vectors and symmetric matrices of four points at once, in functions that are TOLMAN_WIDE_LANES
// (four_doubles.hpp).
#pragma once

#include <Eigen/Core>

#include "four_doubles.hpp"

namespace tolman::feature_stereo {

constexpr int kFour = 4;
using namespace lanes;
using Four = FourDoubles;
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
