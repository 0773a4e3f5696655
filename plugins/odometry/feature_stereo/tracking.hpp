// SPDX-License-Identifier: BSD-3-Clause
// Tracks corners from one image to another by pyramidal Lucas-Kanade, with a forward-backward
// check.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tolman::feature_stereo {

struct TrackSettings {
  int window = 17;           ///< px, side of the patch
  int levels = 4;            ///< of the pyramid
  double consistency = 0.7;  ///< px, largest forward-backward error
};

/// Image pyramid with derivatives, computed once per image.
class FlowPyramid {
 public:
  FlowPyramid() = default;
  /// `gray` is CV_8UC1; it is copied.
  FlowPyramid(const cv::Mat& gray, const TrackSettings& settings);

  bool empty() const { return images_.empty(); }
  cv::Size size() const { return images_.front().size(); }
  /// Level 0 is the image itself.
  const cv::Mat& level(int index) const { return images_[static_cast<std::size_t>(2 * index)]; }
  int levels() const { return static_cast<int>(images_.size()) / 2; }
  const std::vector<cv::Mat>& images() const { return images_; }  ///< in the form of OpenCV

 private:
  std::vector<cv::Mat> images_;  ///< image and derivatives alternately
};

/// Tracks the corners `from` of one image to another. `to` contains guesses and is overwritten.
/// True for corners whose backward track ends within `consistency` of their start. `levels` may be
/// less than that of the pyramid if the guesses are good.
std::vector<bool> trackCorners(const FlowPyramid& from_image, const FlowPyramid& to_image,
                               const std::vector<cv::Point2f>& from, std::vector<cv::Point2f>& to,
                               const TrackSettings& settings);

}  // namespace tolman::feature_stereo
