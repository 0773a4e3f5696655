// SPDX-License-Identifier: BSD-3-Clause
// A camera that stands: its measured steps are noise, which would add up to metres in minutes.
#pragma once

#include <Eigen/Cholesky>

#include "tolman/geometry.hpp"
#include "tolman/records.hpp"

namespace tolman {

/// Pose to report for a frame: the pose that was reported last, as long as the measured one is
/// within the 99 % ellipsoid of its `covariance` from there. A slow motion is therefore reported
/// late, but never lost, because the measured poses do not depend on the reported ones.
inline Eigen::Isometry3d heldWhileStanding(const Eigen::Isometry3d& T_world_reported,
                                           const Eigen::Isometry3d& T_world_measured,
                                           const Matrix6d& covariance) {
  constexpr double kWithin = 16.81;  // 99 % of chi-squared with six degrees of freedom
  const Vector6d step = logSe3(T_world_reported.inverse() * T_world_measured);
  return step.dot(covariance.ldlt().solve(step)) < kWithin ? T_world_reported : T_world_measured;
}

}  // namespace tolman
