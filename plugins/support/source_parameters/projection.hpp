// SPDX-License-Identifier: BSD-3-Clause
// The matrix P = K [I | t] of a rectified camera, as KITTI, ROS and OpenCV write it.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "tolman/camera.hpp"

namespace tolman::source_parameters {

using Projection = Eigen::Matrix<double, 3, 4>;

inline Pinhole pinholeOf(const Projection& P) { return {P(0, 0), P(1, 1), P(0, 2), P(1, 2)}; }

/// t of P, m: the origin of the reference in the axes of the rectified camera.
inline Eigen::Vector3d offsetOf(const Projection& P) {
  const Pinhole K = pinholeOf(P);
  return {(P(0, 3) - K.cx * P(2, 3)) / K.fx, (P(1, 3) - K.cy * P(2, 3)) / K.fy, P(2, 3)};
}

/// Whether a right camera that is at `t` in the axes of the left one is beside it: images of others
/// are not rectified.
inline bool isBeside(const Eigen::Vector3d& t) {
  // Chosen, not tuned. KITTI's colour pairs have 0.005 (odometry) to 0.009 (raw).
  constexpr double kMisaligned = 0.02;  // of the baseline
  return std::hypot(t.y(), t.z()) <= kMisaligned * std::abs(t.x());
}

}  // namespace tolman::source_parameters
