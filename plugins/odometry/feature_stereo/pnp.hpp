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
  int iterations = 100;  ///< most samples; bounds the time
  int min_inliers = 20;  ///< with fewer, tracking is lost; chosen, not tuned
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

// Errors of all matches at a pose, four matches at once.

/// Matches and their weights at one call of estimatePose().
class PoseLanes {
 public:
  PoseLanes(const CameraRig& rig, const std::vector<PointMatch>& matches, const PixelNoise& noise);

  /// Weights each match by the inverse of its covariance at this pose: the pixel noise plus the
  /// uncertainty of the point. So far and new points have less weight.
  void weigh(const Eigen::Isometry3d& T_world_camera);
  /// Squared Mahalanobis distances, in the order of matches; huge for points behind the camera.
  std::vector<double> distances(const Eigen::Isometry3d& T_world_camera) const;
  /// Their sum, each at most `gate`.
  double cost(const Eigen::Isometry3d& T_world_camera, double gate) const;
  /// Normal equations of the matches within `gate`, with Cauchy's weights.
  void linearise(const Eigen::Isometry3d& T_world_camera, double gate, Matrix6d& information,
                 Vector6d& gradient) const;

  /// Four matches; lanes without a match have zeros.
  struct Group {
    LaneReference reference;
    Four3 scaled = {};  ///< scaledPosition()
    Four inverse_depth = {};
    Four3 pixel = {};     ///< relative to the principal point
    Four has_match = {};  ///< 1 or 0
    Four has_disparity = {};
    Four6 covariance = {};  ///< of the coordinates
    Four6 weights = {};
  };

 private:
  LaneCamera camera_;
  PixelNoise noise_;
  std::size_t count_;
  std::vector<Group> groups_;
};

}  // namespace tolman::feature_stereo
