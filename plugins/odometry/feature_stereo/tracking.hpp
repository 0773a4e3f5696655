// SPDX-License-Identifier: BSD-3-Clause
// Image pyramids whose levels have a margin, so that patches may hang over the border.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

namespace tolman::feature_stereo {

/// An image with pixels around it that may be read too.
struct PaddedImage {
  const uchar* origin = nullptr;  ///< the pixel (0, 0)
  std::ptrdiff_t step = 0;        ///< from one row to the next
  int width = 0;
  int height = 0;

  const uchar* at(int x, int y) const { return origin + y * step + x; }
};

/// Columns that are computed at once.
constexpr int kLanes = 16;

/// Smallest multiple of kLanes that is not below `count`.
constexpr int toLanes(int count) { return (count + kLanes - 1) / kLanes * kLanes; }

/// Image pyramid, computed once per image.
class FlowPyramid {
 public:
  FlowPyramid() = default;
  /// `gray` is CV_8UC1.
  FlowPyramid(const cv::Mat& gray, int window, int levels) { build(gray, window, levels); }

  /// Copies `gray` and halves it. `window`: side of the patches that will be read, px. Uses its
  /// memory again: new pages for each image take longer than the computation.
  void build(const cv::Mat& gray, int window, int levels);

  bool empty() const { return images_.empty(); }
  cv::Size size() const { return images_.front().size(); }
  int levels() const { return static_cast<int>(images_.size()); }
  /// Level 0 is the image itself.
  const cv::Mat& level(int index) const { return images_[static_cast<std::size_t>(index)]; }
  PaddedImage padded(int index) const;

 private:
  std::vector<cv::Mat> memory_;  ///< with the margin
  std::vector<cv::Mat> images_;  ///< without it
};

// Tracks corners from one image to another by pyramidal Lucas-Kanade, with a forward-backward
// check.

struct TrackSettings {
  int window = 15;           ///< px, side of the patch; odd
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
