// SPDX-License-Identifier: BSD-3-Clause
// Disparities (px) of corners: a search along the row, then sub-pixel Lucas-Kanade, with a
// left-right check.
#pragma once

#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "tracking.hpp"

namespace tolman::feature_stereo {

struct StereoSettings {
  TrackSettings track;         ///< `levels` limits the refinement of a guess
  double max_disparity = 150;  ///< px
  double min_disparity = -1;   ///< px; noise makes some far disparities negative, and dropping only
                               ///< these would bias far points towards the camera
  double epipolar = 1;         ///< px, largest difference of rows; chosen, not tuned
};

/// Means "no guess" or "no match".
constexpr float kNoDisparity = std::numeric_limits<float>::quiet_NaN();

/// The disparity u_left - u_right of each corner, or kNoDisparity. `guesses` is as long as
/// `corners`; a corner without a guess is searched for along its row.
std::vector<float> matchStereo(const FlowPyramid& left, const FlowPyramid& right,
                               const std::vector<cv::Point2f>& corners,
                               const std::vector<float>& guesses, const StereoSettings& settings);

}  // namespace tolman::feature_stereo
