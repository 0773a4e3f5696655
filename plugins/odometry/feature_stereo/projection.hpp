// SPDX-License-Identifier: BSD-3-Clause
// Landmarks in inverse depth and their projection into a rectified stereo pair.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "tolman/camera.hpp"
#include "tolman/geometry.hpp"

namespace tolman::feature_stereo {

/// The measurement of a point in one stereo frame: u, v of the left image and the disparity d, px.
/// An error of the tracker shifts u equally in both images, so the errors of (u, v, d) are
/// independent, those of (u_left, v, u_right) are not.
using StereoPixel = Eigen::Vector3d;

/// Largest squared error of an inlier, in variances: 99 % quantile of chi-square with 3 degrees of
/// freedom.
inline constexpr double kGate = 11.34;

/// Accuracy of a StereoPixel. The appearance of near points changes more between images than that
/// of far ones, so their errors grow with the disparity d: sigma(d) = sigma(0) sqrt(1 +
/// (d/doubling)^2). On road scenes (KITTI) one `doubling` fits tracks and disparities; with a
/// constant sigma the least accurate measurements would determine the scale.
struct PixelNoise {
  double track = 0.25;      ///< px, of u and of v, for far points
  double disparity = 0.15;  ///< px, for far points
  double doubling = 14;     ///< px of disparity

  /// Standard deviations of u, v and d at this disparity.
  Eigen::Vector3d sigma(double at_disparity) const {
    const double ratio = at_disparity / doubling;
    return std::sqrt(1 + ratio * ratio) * Eigen::Vector3d(track, track, disparity);
  }
};

/// A landmark. `coordinates` are (x/z, y/z, 1/z) in a fixed reference camera. They are not singular
/// at infinity, so far points need no special treatment. The error of the inverse depth is
/// symmetric and does not bias the motion; that of the depth would.
struct InverseDepthPoint {
  Eigen::Isometry3d T_world_reference = Eigen::Isometry3d::Identity();
  Eigen::Vector3d coordinates = Eigen::Vector3d::Zero();
};

/// Derivatives of a StereoPixel.
struct ProjectionJacobians {
  Eigen::Matrix<double, 3, 6> pose;  ///< with respect to d in T_world_camera * expSe3(d)
  Eigen::Matrix3d point;             ///< with respect to the point's coordinates
};

/// The point's position in the camera times its inverse depth in the reference.
Eigen::Vector3d scaledCameraPoint(const Eigen::Isometry3d& T_world_camera,
                                  const InverseDepthPoint& point);

/// Empty for a point that is not in front of the camera. `jacobians` may be null.
std::optional<StereoPixel> project(const CameraRig& rig, const Eigen::Isometry3d& T_world_camera,
                                   const InverseDepthPoint& point,
                                   ProjectionJacobians* jacobians = nullptr);

/// The inverse of project() at the reference itself.
Eigen::Vector3d triangulate(const CameraRig& rig, const StereoPixel& pixel);

/// Covariance of triangulate(): linear in inverse depth, hence exact.
Eigen::Matrix3d triangulationCovariance(const CameraRig& rig, const Eigen::Vector3d& sigma);

}  // namespace tolman::feature_stereo
