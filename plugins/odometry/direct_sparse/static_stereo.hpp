// SPDX-License-Identifier: BSD-3-Clause
// Static stereo (Wang et al., ICCV 2017): disparity (px) of a pixel of the left image
// by a search along its row in the right image.
#pragma once

#include <optional>

#include "pyramid.hpp"
#include "tolman/camera.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

inline constexpr int kMaxDisparities = 512;  // px; bounds the time of a row search

struct StereoSearch {
  int max_disparity = 160;  ///< px, at most kMaxDisparities
  float gain = 1;           ///< right = gain * left + offset
  float offset = 0;         ///< grey levels
};

struct StereoMatch {
  float disparity = 0;  ///< px, slightly negative for far points is possible
  float sigma = 0;      ///< px
  float quality = 0;    ///< second best cost over best cost
};

/// Pixels (u, v) must be kStereoBorder away from the edge.
inline constexpr int kStereoBorder = 5;

/// Sums of absolute differences over 8x5 pixels for each disparity, checked from right to left, and
/// refined to sub-pixel accuracy. Empty if the match is weak, ambiguous or fails the check.
std::optional<StereoMatch> matchStereo(const GrayLevel& left, const GrayLevel& right, int u, int v,
                                       const StereoSearch& search);

/// Gain and offset of the right image from the grey statistics of both.
void balanceBrightness(const GrayLevel& left, const GrayLevel& right, StereoSearch& search);

// Whether static stereo of a frame agrees with the pose at which the frame was tracked. After a gap
// a frame may be aligned at a wrong place, where the pose predicts wrong depths.

/// Number of points of the window that are in the image of a frame, and number of those whose
/// disparity is the one that the pose T_world_camera of the frame predicts.
struct StereoAgreement {
  int compared = 0;  ///< points with a disparity of static stereo
  int agreeing = 0;
  /// At the right place nearly all agree: 115 of 117 on kitti_clips/06. At a wrong place only few
  /// points can be matched: 3 of 14 agreed on 01. Chosen on 06, on the town in
  /// traffic and on one fault of 01 (docs/report/odometry.md).
  bool confirms() const { return agreeing >= 20 && 2 * agreeing >= compared; }
};

/// At most some hundred points are compared. `max_disparity` (px) is as in StereoSearch.
StereoAgreement compareWithStereo(const CameraRig& rig, const Window& window,
                                  const Eigen::Isometry3d& T_world_camera, const GrayLevel& left,
                                  const GrayLevel& right, int max_disparity);

}  // namespace tolman::direct_sparse
