// SPDX-License-Identifier: BSD-3-Clause
// Splits motions in space into a step on the horizontal plane and a climb.
#pragma once

#include "grid_code.hpp"
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

// Estimates the up direction from the motion: a camera that is fixed to a vehicle, however it is
// mounted, moves along one direction of its own axes and turns about another.

/// Sums over the motions so far, from which the vehicle's axes are estimated, in camera axes.
struct Upright {
  Eigen::Vector3d forward = Eigen::Vector3d::Zero();  ///< m, sum of steps; backward ones reversed
  double path = 0;                                    ///< m, length of all steps
  Eigen::Matrix3d turns = Eigen::Matrix3d::Zero();    ///< rad^2, sum of w w^T over turns w
  Eigen::Matrix3d R_first_camera = Eigen::Matrix3d::Identity();  ///< by odometry
  Eigen::Matrix3d R_turn_camera = Eigen::Matrix3d::Identity();   ///< since the last whole turn

  void add(const Eigen::Isometry3d& T_previous_current);

  /// Unit vector in the axes of the present camera. It is assumed that the vehicle is level at the
  /// first frame. At first the camera is assumed to be level there, too. When it has moved 1 m,
  /// nearly all in one direction of its own axes, this direction is taken as horizontal; when it
  /// has turned enough about one axis, this axis is taken as vertical. A hand-held camera has no
  /// such axes, so its first image is assumed to be level.
  Eigen::Vector3d up() const { return R_first_camera.transpose() * upOfVehicle(); }

 private:
  bool isVehicle() const;
  Eigen::Vector3d upOfVehicle() const;
};

}  // namespace tolman::bayesian_attractor
