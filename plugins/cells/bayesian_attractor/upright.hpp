// SPDX-License-Identifier: BSD-3-Clause
// The up direction, estimated from the motion: a camera that is fixed to a vehicle moves along one
// of its own axes and turns about another, however it is mounted.
#pragma once

#include "level_step.hpp"

namespace tolman::bayesian_attractor {

/// Sums over the motions so far, from which the vehicle's axes are estimated, in camera axes.
struct Upright {
  Eigen::Vector3d forward = Eigen::Vector3d::Zero();  ///< m, sum of steps; backward ones reversed
  double path = 0;                                    ///< m, length of all steps
  Eigen::Matrix3d turns = Eigen::Matrix3d::Zero();    ///< rad^2, sum of w w^T over turns w
  Eigen::Matrix3d R_first_camera = Eigen::Matrix3d::Identity();  ///< by odometry
  Eigen::Matrix3d R_turn_camera = Eigen::Matrix3d::Identity();   ///< since the last whole turn

  void add(const Eigen::Isometry3d& T_previous_current);

  /// Unit vector in the axes of the camera now. The vehicle is taken to be level at the first
  /// frame. So is the camera, until it has moved 1 m in nearly one direction of its own, which is
  /// then level, and has turned about one axis, which is then upright. A camera in a hand has no
  /// such axes: for it the first image is taken to be level.
  Eigen::Vector3d up() const { return R_first_camera.transpose() * upOfVehicle(); }

 private:
  bool isVehicle() const;
  Eigen::Vector3d upOfVehicle() const;
};

}  // namespace tolman::bayesian_attractor
