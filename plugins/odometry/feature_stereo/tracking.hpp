// SPDX-License-Identifier: BSD-3-Clause
// Tracks corners from one image to another by pyramidal Lucas-Kanade, with a forward-backward
// check.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "flow_pyramid.hpp"

namespace tolman::feature_stereo {

struct TrackSettings {
  int window = 15;           ///< px, side of the patch
  int levels = 3;            ///< of the pyramid
  double consistency = 0.7;  ///< px, largest forward-backward error
};

/// Tracks the corners `from` of one image to another. `to` contains guesses and is overwritten.
/// True for corners whose backward track ends within `consistency` of their start. `levels` may be
/// less than that of the pyramid if the guesses are good.
std::vector<bool> trackCorners(const FlowPyramid& from_image, const FlowPyramid& to_image,
                               const std::vector<cv::Point2f>& from, std::vector<cv::Point2f>& to,
                               const TrackSettings& settings);

}  // namespace tolman::feature_stereo
