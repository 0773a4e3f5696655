// SPDX-License-Identifier: BSD-3-Clause
// Splits motions in space into a step on the horizontal plane and a climb.
#pragma once

#include "height_code.hpp"
#include "tolman/geometry.hpp"

namespace tolman::bayesian_attractor {

/// Upwards in the axes of a level camera (x right, y down, z forward).
inline const Eigen::Vector3d kLevelUp = -Eigen::Vector3d::UnitY();

struct LevelStep {
  PlanarPose plane;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, heading), diagonal
  Climb climb;
  Eigen::Vector3d up = kLevelUp;  ///< unit vector, in the axes of the camera after the step
};

/// Four degrees of freedom of a motion: step on the plane, turn, climb. `up_from` is the up
/// direction in the axes of the start; pitch and roll of the motion change only LevelStep::up.
/// `covariance` is in the tangent space of the end.
LevelStep levelStep(const Eigen::Isometry3d& T_from_to, const Matrix6d& covariance,
                    const Eigen::Vector3d& up_from);

/// The same on the plane of the camera's x and z axes, as if the camera were level: no climb.
LevelStep planarStep(const Eigen::Isometry3d& T_from_to, const Matrix6d& covariance);

}  // namespace tolman::bayesian_attractor
