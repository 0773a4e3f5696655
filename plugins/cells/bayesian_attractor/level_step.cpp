// SPDX-License-Identifier: BSD-3-Clause
#include "level_step.hpp"

#include <Eigen/Geometry>

namespace tolman::bayesian_attractor {
namespace {

/// The smallest rotation that makes the camera level.
Eigen::Matrix3d levelling(const Eigen::Vector3d& up) {
  return Eigen::Quaterniond::FromTwoVectors(up, kLevelUp).toRotationMatrix();
}

/// Covariance of (forward, left, heading): the camera's z and -x, and the rotation about -y.
/// Correlations are dropped.
Eigen::Matrix3d planarVariance(const Matrix6d& covariance) {
  return Eigen::Vector3d(covariance(2, 2), covariance(0, 0), covariance(4, 4)).asDiagonal();
}

}  // namespace

LevelStep levelStep(const Eigen::Isometry3d& T_from_to, const Matrix6d& covariance,
                    const Eigen::Vector3d& up_from) {
  LevelStep step;
  step.up = (T_from_to.linear().transpose() * up_from).normalized();
  const Eigen::Matrix3d R_level_to = levelling(step.up);
  const Eigen::Isometry3d T_level =
      Eigen::Isometry3d(levelling(up_from)) * T_from_to * Eigen::Isometry3d(R_level_to.transpose());
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = R_level_to;
  const Matrix6d level_covariance = turn * covariance * turn.transpose();
  step.plane = toPlanar(T_level);
  step.covariance = planarVariance(level_covariance);
  step.climb = {-T_level.translation().y(), level_covariance(1, 1)};
  return step;
}

LevelStep planarStep(const Eigen::Isometry3d& T_from_to, const Matrix6d& covariance) {
  return {toPlanar(T_from_to), planarVariance(covariance), {}, kLevelUp};
}

}  // namespace tolman::bayesian_attractor
