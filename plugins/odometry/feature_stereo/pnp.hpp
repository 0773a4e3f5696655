// SPDX-License-Identifier: BSD-3-Clause
// Camera pose from 3D-2D matches (m, rad): RANSAC over P3P (Ke and Roumeliotis, CVPR 2017), then
// robust Gauss-Newton steps.
#pragma once

#include <optional>
#include <vector>

#include "projection.hpp"
#include "tolman/context.hpp"

namespace tolman::feature_stereo {

struct PnpSettings {
  PixelNoise noise;
  int iterations = 100;  ///< most samples
  int min_inliers = 20;
};

/// A point and its pixel in the image whose pose is estimated.
struct PointMatch {
  InverseDepthPoint point;
  Eigen::Matrix3d point_covariance = Eigen::Matrix3d::Zero();  ///< of its coordinates
  StereoPixel pixel = StereoPixel::Zero();
  bool has_disparity = false;  ///< false: pixel.z() is undefined
};

struct PoseEstimate {
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();  ///< from the normal equations
  std::vector<bool> inlier;                ///< for each match
  int inliers = 0;
};

/// The pose that most matches agree with. `guess` is the first hypothesis; the samples come only
/// from `random`. Empty if fewer than min_inliers agree.
std::optional<PoseEstimate> estimatePose(const CameraRig& rig,
                                         const std::vector<PointMatch>& matches,
                                         const Eigen::Isometry3d& guess,
                                         const PnpSettings& settings, RandomStream& random);

}  // namespace tolman::feature_stereo
