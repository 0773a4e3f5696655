// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with cameras and their images. A calibration of other images gives depths and paths
// that are wrong by a factor, and odometry may mistake faults of images for motion.
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/context.hpp"
#include "tolman/image.hpp"
#include "tolman/records.hpp"

namespace tolman::engine {

/// What to look at in the cameras of a source: a baseline below 1 cm or above 10 m, a principal
/// point far from the middle of the image, focal lengths that differ between the two directions by
/// more than 5 %, or that give a view which such cameras do not have. `raw` is empty where the
/// source gives rectified images; `rectified` is the rig that the stages get.
std::vector<std::string> cameraDoubts(const RawRig& raw, const CameraRig& rectified);

/// Whether the image is nearly black, as images of 14 bits or fewer that are taken for 16 bits: not
/// one in ten thousand values (a hot pixel) reaches a quarter of the grey levels. False for an
/// empty image.
bool isNearlyBlack(const Image& image);

/// A grey image with half the width and height: the mean of 2x2 pixels, of the green channel for
/// colour images.
cv::Mat halfOf(const Image& image);

/// How corners of the left image are found in the right one. In a rectified pair with simultaneous
/// exposure they are in the same row, further left. Pixels are those of the full images.
struct StereoMeasure {
  int corners = 0;             ///< number of corners that were searched for
  int matched = 0;             ///< number of unambiguous matches
  double rows_low = 0;         ///< median of row in the right image minus row in the left one, px
  double spread = 0;           ///< 80th percentile of the deviation of that from its median, px
  double to_left = 0;          ///< median disparity, px
  double share_exchanged = 0;  ///< share of the matches that are further right in the right image
};

/// Deterministic; about 5 ms for images of 1241 x 376 px.
StereoMeasure measureStereo(const cv::Mat& left, const cv::Mat& right);

enum class StereoFault { None, RowsApart, Exchanged, OtherTime };

/// None also if too few corners are matched.
StereoFault faultOf(const StereoMeasure& measure);

/// "the right image is 3.0 px low; are the images rectified?"
std::string faultText(StereoFault fault, const StereoMeasure& measure);

/// Detects that every second image has more texture: a projector of dots that is on for every
/// second pair (`emitter_on_off`), or two exposures. The dots stand still in the camera.
class Alternation {
 public:
  /// The finding, once, with the image that makes it certain.
  std::optional<Finding> add(const Image& image);

 private:
  std::vector<double> textures_;
};

/// Checks the images of each frame before the stages get them: a camera that repeats its last
/// image, a right image that equals the left one, exchanged images, a right image of another time,
/// or one with shifted rows.
class FrameCheck {
 public:
  /// Call it with each frame, in order. If the images have a fault, both are removed, or only the
  /// right one is made black; `defect` and the result then say why.
  std::optional<std::string> check(Frame& frame);

 private:
  enum class Use { Both, Left, None };
  Use useOf(const Frame& frame, std::string& defect);
  StereoFault stereoFault(const Frame& frame);
  bool isLate(const StereoMeasure& measure, const cv::Mat& right);

  Image left_;              ///< of the last frame that had images
  Image right_;             ///< likewise
  int until_measured_ = 0;  ///< frames
  bool late_ = false;       ///< right images were found to be of the frame before
  int sound_measures_ = 0;  ///< in succession
  StereoFault last_measured_ = StereoFault::None;
  StereoFault fault_ = StereoFault::None;
  std::string stereo_text_;  ///< of the last measure with that fault
};

}  // namespace tolman::engine
