// SPDX-License-Identifier: BSD-3-Clause
// A depth image (RGB-D camera, lidar) in place of the right image: its depths become disparities of
// a right camera that does not exist, so that pose and window work as with a pair (the idea is that
// of ORB-SLAM2, Mur-Artal and Tardos, T-RO 2017, III-A).
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::feature_stereo {

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
