// SPDX-License-Identifier: BSD-3-Clause
#include "engine/frame_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tolman::engine {
namespace {

// Measuring a pair takes 2 ms, so only every fifth frame is measured; every frame during a fault.
constexpr int kMeasuredEvery = 5;    // frames
constexpr int kCertain = 12;         // matches; with fewer, two measures must find the same fault
constexpr int kSoundAgain = 5;       // measures without a fault, in succession, that end it
constexpr std::size_t kFewest = 20;  // matches of which rowsText() speaks
constexpr std::size_t kMostRows = 500;  // likewise

/// Whether two images have the same pixels. Two exposures of a real camera never have, because of
/// noise.
bool samePixels(const Image& a, const Image& b) {
  if (a.empty() || a.width() != b.width() || a.height() != b.height() || a.format() != b.format()) {
    return false;
  }
  const auto bytes = static_cast<std::size_t>(a.width() * bytesPerPixel(a.format()));
  for (int r = 0; r < a.height(); ++r) {
    if (std::memcmp(a.row(r), b.row(r), bytes) != 0) return false;
  }
  return true;
}

/// Whether all pixels are equal. A covered camera or darkness gives such images again and again,
/// which is not a fault here: odometry detects it.
bool isUniform(const Image& image) {
  const std::size_t bytes = static_cast<std::size_t>(image.width() * bytesPerPixel(image.format()));
  for (int r = 0; r < image.height(); ++r) {
    const std::uint8_t* row = image.row(r);
    if (std::any_of(row, row + bytes, [&](std::uint8_t v) { return v != image.row(0)[0]; })) {
      return false;
    }
  }
  return true;
}

/// A black image, because a pair must have two images or none.
Image darkened(const Image& image) {
  return Image::create(image.width(), image.height(), image.format(), [](std::uint8_t*) {});
}

}  // namespace

/// The present fault of the pair. A fault that is measured with few matches counts only if two
/// measures in succession find it. It ends after kSoundAgain measures without a fault.
StereoFault FrameCheck::stereoFault(const Frame& frame) {
  if (frame.right.empty() || until_measured_-- > 0) return fault_;
  const StereoMeasure measure = measureStereo(grayHalf(frame.left), grayHalf(frame.right));
  const StereoFault measured = faultOf(measure);
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

FrameCheck::Verdict FrameCheck::verdictOn(const Frame& frame) {
  const bool left = samePixels(frame.left, left_) && !isUniform(frame.left);
  const bool right = samePixels(frame.right, right_) && !isUniform(frame.right);
  if (left) {
    return {Use::None, right ? "both images repeat those of the frame before: no new ones come"
                             : "the left image repeats that of the frame before: no new one comes"};
  }
  if (right) {
    return {Use::Left, "the right image repeats that of the frame before: no new one comes"};
  }
  if (samePixels(frame.left, frame.right) && !isUniform(frame.left)) {
    return {Use::Left, "the right image is the left one"};
  }
  const StereoFault fault = stereoFault(frame);
  if (fault == StereoFault::None) return {};
  return {fault == StereoFault::Exchanged ? Use::None : Use::Left, stereo_text_};
}

std::optional<std::string> FrameCheck::check(Frame& frame) {
  if (frame.left.empty()) return std::nullopt;
  const Verdict verdict = verdictOn(frame);
  left_ = frame.left;
  right_ = frame.right;
  if (verdict.use == Use::Both) return std::nullopt;
  if (verdict.use == Use::Left) frame.right = darkened(frame.right);
  if (verdict.use == Use::None) frame.left = frame.right = Image();
  frame.defect = verdict.text;
  return verdict.text;
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
