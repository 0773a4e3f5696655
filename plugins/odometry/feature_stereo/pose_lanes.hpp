// SPDX-License-Identifier: BSD-3-Clause
// Errors of all matches at a pose, four matches at once.
#pragma once

#include <vector>

#include "pnp.hpp"
#include "projection_lanes.hpp"

namespace tolman::feature_stereo {

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
