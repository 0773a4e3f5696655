// SPDX-License-Identifier: BSD-3-Clause
// A relative pose with its 6x6 covariance, T = T_estimate * expSe3(noise), and the propagation of
// the covariance through composition, inversion and projection to the plane, to first order.
#pragma once

#include <path_calibration.hpp>
#include <tolman/geometry.hpp>

namespace tolman::experience_map {

struct UncertainPose {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();  ///< m and rad, in the tangent space of its end
};

/// A motion over several frames.
struct PathMotion : UncertainPose {
  double length = 0;  ///< m driven
  /// Of the steady errors on its end (path_calibration).
  Eigen::Matrix<double, 6, kSpatialErrors> effect =
      Eigen::Matrix<double, 6, kSpatialErrors>::Zero();
};

/// a followed by b, with independent noises.
UncertainPose compose(const UncertainPose& a, const UncertainPose& b);

/// The inverse motion.
UncertainPose inverse(const UncertainPose& a);

/// Diagonal covariance of standard deviations in m and rad.
Matrix6d isotropic(double sigma_translation, double sigma_rotation);

/// What a small motion of a camera with attitude R_world_camera is in the plane: (forward, left,
/// counter-clockwise), along the axes of a heading `theta` in that plane.
Eigen::Matrix<double, 3, 6> planarProjection(const Eigen::Matrix3d& R_world_camera, double theta);

}  // namespace tolman::experience_map
