// SPDX-License-Identifier: BSD-3-Clause
// Disparities of corners: from the right image, or from a depth image.
//
// Whole-pixel disparities: a patch is compared with all places of its row.
#pragma once

#include <limits>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/status.hpp"
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

// A depth image (RGB-D camera, lidar) in place of the right image: its depths become disparities of
// a right camera that does not exist, so that pose and window work as with a pair (the idea is that
// of ORB-SLAM2, Mur-Artal and Tardos, T-RO 2017, III-A).

/// Baseline of the camera that does not exist, m. Poses do not depend on it: disparities and their
/// standard deviations are proportional to it.
inline constexpr double kVirtualBaseline = 0.1;

/// The depth image of a frame, "depth.left" or "depth" (m along the optical axis; 0, negative or
/// not finite where nothing was measured). Null if the frame has none.
const NamedArray* depthImage(const Frame& frame);

/// Unsupported for an image without depth image, InvalidInput for a depth image of another size.
Status requireDepth(const Frame& frame, const CameraRig& rig);

/// The disparity of each corner, by bilinear interpolation of inverse depths (which are linear on a
/// plane); kNoDisparity where one of the four depths around it is missing, or where they differ as
/// at an edge of an object. `fx_baseline`: px m.
std::vector<float> depthDisparities(const NamedArray& depth,
                                    const std::vector<cv::Point2f>& corners, double fx_baseline);

// Depth images that are no measurement of their frame: a sensor that repeats its last image, or
// gives one value everywhere.

class FreshDepth {
 public:
  enum class Kind { Fresh, Repeated, Constant };
  /// Of the depth image of the next frame; null: Fresh. Unmeasured values do not count, and an
  /// image without any other is Fresh.
  Kind judge(const NamedArray* depth);

 private:
  std::vector<float> last_;  ///< values of the last image that was not Constant
};

}  // namespace tolman::feature_stereo
