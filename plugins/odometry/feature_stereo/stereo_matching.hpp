// SPDX-License-Identifier: BSD-3-Clause
// Whole-pixel disparities: a patch is compared with all places of its row.
#pragma once

#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "tracking.hpp"

namespace tolman::feature_stereo {

/// Compares patches of the left image with those on the same row of the right one.
class RowSearch {
 public:
  RowSearch(const PaddedImage& left, const PaddedImage& right, int max_disparity);

  /// The best disparity by sums of absolute differences, with the patches' means removed;
  /// kNoDisparity if the best is not clearly better than the second best.
  float find(cv::Point corner);

  /// The sums for disparities from 0 on; empty for a corner near the border.
  const std::vector<int>& costsAt(cv::Point corner);

 private:
  PaddedImage left_;
  PaddedImage right_;
  int max_disparity_;
  std::vector<int> costs_;
};

// Disparities (px) of corners: a search along the row, then sub-pixel Lucas-Kanade, with a
// left-right check.

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
