// SPDX-License-Identifier: BSD-3-Clause
// The camera's pose from points and where they are seen: three-point samples, then least squares.
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

/// A point and its sighting in the image whose pose is wanted.
struct Sighting {
  InverseDepthPoint point;
  Eigen::Matrix3d point_covariance = Eigen::Matrix3d::Zero();  ///< of its coordinates
  StereoPixel pixel = StereoPixel::Zero();
  bool has_disparity = false;  ///< else pixel.z() means nothing
};

struct PoseEstimate {
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();  ///< from the normal equations
  std::vector<bool> inlier;                ///< for each sighting
  int inliers = 0;
};

/// The pose that most sightings agree on. `guess` is the first hypothesis and breaks no tie; the
/// samples come from `random` alone. Nothing when fewer than min_inliers agree.
std::optional<PoseEstimate> estimatePose(const CameraRig& rig,
                                         const std::vector<Sighting>& sightings,
                                         const Eigen::Isometry3d& guess,
                                         const PnpSettings& settings, RandomStream& random);

}  // namespace tolman::feature_stereo
