// SPDX-License-Identifier: BSD-3-Clause
#include "engine/camera_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace tolman::engine {

namespace {

constexpr double kNearest = 0.01;  // m, of two cameras
constexpr double kWidest = 10;     // m
/// Lenses are centred within a few percent; images cut at one side are within a quarter.
constexpr double kOffCentre = 0.25;
constexpr double kSquare = 1.05;  // KITTI, EuRoC and TUM-VI: 1.00 to 1.003; not tuned
// Rectified images of wider lenses are cut, since their edges would be stretched threefold.
constexpr double kWidestRectified = 115;  // degrees
constexpr double kWidestRaw = 160;        // degrees; of a lens with radial distortion
constexpr double kNarrowest = 3;          // degrees

/// `whose` begins with a space.
void checkPinhole(const Pinhole& K, int width, int height, double widest, const std::string& whose,
                  std::vector<std::string>& doubts) {
  if (width <= 0 || height <= 0 || !(K.fx > 0) || !(K.fy > 0)) return;
  if (std::abs(K.cx / width - 0.5) > kOffCentre || std::abs(K.cy / height - 0.5) > kOffCentre) {
    doubts.push_back(fmt::format(
        "the principal point{} ({:.1f}, {:.1f}) is far from the middle of the {}x{} image; were "
        "the images resized after the calibration? Then scale fx, fy, cx, cy as well",
        whose, K.cx, K.cy, width, height));
  }
  const double half = std::max(width / K.fx, height / K.fy) / 2;
  const double degrees = 2 * std::atan(half) * 180 / std::numbers::pi;
  if (degrees < kNarrowest || degrees > widest) {
    doubts.push_back(fmt::format(
        "the focal length{} ({:.1f}, {:.1f}) gives the {}x{} image a view of {:.0f} degrees, which "
        "such cameras do not have; is it that of these images, in pixels? Depths and paths are "
        "wrong by its error",
        whose, K.fx, K.fy, width, height, degrees));
  }
  if (std::max(K.fx, K.fy) > kSquare * std::min(K.fx, K.fy)) {
    doubts.push_back(fmt::format(
        "the focal lengths{} are {:.5g} px horizontally and {:.5g} px vertically, and pixels of "
        "cameras are nearly square: if the images were not resized by different factors in the two "
        "directions, correct fx or fy in the calibration",
        whose, K.fx, K.fy));
  }
}

}  // namespace

std::vector<std::string> cameraDoubts(const RawRig& raw, const CameraRig& rectified) {
  std::vector<std::string> doubts;
  if (rectified.isStereo() && (rectified.baseline < kNearest || rectified.baseline > kWidest)) {
    doubts.push_back(fmt::format(
        "the two cameras are {:.4g} m apart, and usual pairs 0.01 to 10 m; all lengths of the run "
        "are in this unit: if they are not that far apart, correct the baseline (in metres, not mm "
        "or cm) in the calibration or in the source's parameters",
        rectified.baseline));
  }
  for (std::size_t i = 0; i < raw.cameras.size(); ++i) {
    const RawCamera& camera = raw.cameras[i];
    const bool is_wide =
        camera.model == LensModel::Equidistant || camera.model == LensModel::Omnidirectional;
    const char* whose = raw.cameras.size() < 2 ? ""
                        : i == 0               ? " of the left camera"
                                               : " of the right camera";
    checkPinhole(camera.pinhole, camera.width, camera.height, is_wide ? 360 : kWidestRaw, whose,
                 doubts);
  }
  if (raw.cameras.empty() && rectified.calibrated) {
    checkPinhole(rectified.pinhole, rectified.width, rectified.height, kWidestRectified, "",
                 doubts);
  }
  return doubts;
}

bool isNearlyBlack(const Image& image) {
  constexpr int kQuarter = 64;
  constexpr std::int64_t kShare = 10'000;
  const std::ptrdiff_t bytes = std::ptrdiff_t{image.width()} * bytesPerPixel(image.format());
  std::int64_t bright = 0;
  for (int r = 0; r < image.height(); ++r) {
    bright += std::count_if(image.row(r), image.row(r) + bytes,
                            [](std::uint8_t value) { return value >= kQuarter; });
  }
  return !image.empty() && bright <= bytes * image.height() / kShare;
}

namespace {

// Measuring a pair takes 2 ms, so only every fifth frame is measured; every frame during a fault.
constexpr int kMeasuredEvery = 5;    // frames
constexpr int kCertain = 12;         // matches; with fewer, two measures must find the same fault
constexpr int kSoundAgain = 5;       // measures without a fault, in succession, that end it
constexpr std::size_t kFewest = 20;  // matches of which rowsText() speaks
constexpr std::size_t kMostRows = 500;  // likewise

/// Whether two images have the same pixels, and not one grey level alone. Two exposures of a real
/// camera never have, because of noise; a covered camera or darkness gives such images again and
/// again, which odometry detects.
bool isRepeated(const Image& a, const Image& b) {
  if (a.empty() || a.width() != b.width() || a.height() != b.height() || a.format() != b.format()) {
    return false;
  }
  const auto bytes = std::ptrdiff_t{a.width()} * bytesPerPixel(a.format());
  bool is_uniform = true;
  for (int r = 0; r < a.height(); ++r) {
    const std::uint8_t* row = a.row(r);
    if (!std::equal(row, row + bytes, b.row(r))) return false;
    is_uniform = is_uniform && std::count(row, row + bytes, a.row(0)[0]) == bytes;
  }
  return !is_uniform;
}

}  // namespace

/// Whether the right image and the left one before it are a sound pair: where the camera turns, an
/// image that is a frame late looks as if both were exchanged.
bool FrameCheck::isLate(const Image& right) const {
  if (left_.empty()) return false;
  const StereoMeasure before = measureStereo(grayHalf(left_), grayHalf(right));
  return before.matched >= kCertain && faultOf(before) == StereoFault::None;
}

/// The present fault of the pair. A fault that is measured with few matches counts only if two
/// measures in succession find it. It ends after kSoundAgain measures without a fault.
StereoFault FrameCheck::stereoFault(const Frame& frame) {
  if (frame.right.empty() || until_measured_-- > 0) return fault_;
  const StereoMeasure measure = measureStereo(grayHalf(frame.left), grayHalf(frame.right));
  StereoFault measured = faultOf(measure);
  if (measured == StereoFault::Exchanged && isLate(frame.right)) measured = StereoFault::OtherTime;
  if (rows_.size() < kMostRows) {
    rows_.insert(rows_.end(), measure.rows.begin(), measure.rows.end());
  }
  const bool certain = measure.matched >= kCertain || measured == last_measured_;
  last_measured_ = measured;
  if (measured != StereoFault::None) {
    if (certain) fault_ = measured;
    if (certain) stereo_text_ = faultText(measured, measure);
    sound_measures_ = 0;
  } else if (++sound_measures_ >= kSoundAgain) {
    fault_ = StereoFault::None;
  }
  const bool settled = fault_ == StereoFault::None && measured == StereoFault::None;
  until_measured_ = settled ? kMeasuredEvery - 1 : 0;
  return fault_;
}

FrameCheck::Use FrameCheck::useOf(const Frame& frame, std::string& defect) {
  const bool left = isRepeated(frame.left, left_);
  const bool right = isRepeated(frame.right, right_);
  if (left || right) {
    defect = left && right ? "both images repeat those of the frame before: no new ones come"
             : left        ? "the left image repeats that of the frame before: no new one comes"
                           : "the right image repeats that of the frame before: no new one comes";
    return left ? Use::None : Use::Left;
  }
  if (isRepeated(frame.left, frame.right)) {
    defect = "the right image is the left one";
    return Use::Left;
  }
  const StereoFault fault = stereoFault(frame);
  if (fault == StereoFault::None) return Use::Both;
  defect = stereo_text_;
  return fault == StereoFault::Exchanged ? Use::None : Use::Left;
}

std::optional<std::string> FrameCheck::check(Frame& frame) {
  if (frame.left.empty()) return std::nullopt;
  std::string defect;
  const Use use = useOf(frame, defect);
  left_ = frame.left;
  right_ = frame.right;
  if (use == Use::Both) return std::nullopt;
  if (use == Use::None) {
    frame.left = frame.right = Image();
  } else {  // black, because a pair must have two images or none
    const Image& right = frame.right;
    frame.right =
        Image::create(right.width(), right.height(), right.format(), [](std::uint8_t*) {});
  }
  return frame.defect = defect;
}

std::string FrameCheck::rowsText() const {
  if (rows_.size() < kFewest) return "";
  const double low = quantile(rows_, 0.5);
  std::vector<double> apart = rows_;
  for (double& row : apart) row = std::fabs(row);
  return fmt::format(
      "of {} corners the right image is {:.1f} px {} (median), and 90 % are within {:.1f} px",
      rows_.size(), std::fabs(low), low < 0 ? "high" : "low", quantile(apart, 0.9));
}

}  // namespace tolman::engine
