// SPDX-License-Identifier: BSD-3-Clause
#include "engine/frame_check.hpp"

#include <algorithm>
#include <cstring>

namespace tolman::imaging {
namespace {

// Measuring a pair takes 2 ms, so only every fifth frame is measured; every frame during a fault.
constexpr int kMeasuredEvery = 5;  // frames
constexpr int kCertain = 12;       // matches; with fewer, two measures must find the same fault
constexpr int kSoundAgain = 5;     // measures without a fault, in succession, that end it

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
    return {Fault::Left, Use::None,
            right ? "both images repeat those of the frame before: no new ones come"
                  : "the left image repeats that of the frame before: no new one comes"};
  }
  if (right)
    return {Fault::Right, Use::Left,
            "the right image repeats that of the frame before: no new one comes"};
  if (samePixels(frame.left, frame.right) && !isUniform(frame.left)) {
    return {Fault::Equal, Use::Left, "the right image is the left one"};
  }
  switch (stereoFault(frame)) {
    case StereoFault::None:
      break;
    case StereoFault::Exchanged:
      return {Fault::Exchanged, Use::None, stereo_text_};
    case StereoFault::RowsApart:
      return {Fault::RowsApart, Use::Left, stereo_text_};
    case StereoFault::OtherTime:
      return {Fault::OtherTime, Use::Left, stereo_text_};
  }
  return {};
}

std::optional<std::string> FrameCheck::check(Frame& frame) {
  if (frame.left.empty()) return std::nullopt;
  const Verdict verdict = verdictOn(frame);
  left_ = frame.left;
  right_ = frame.right;
  if (verdict.use == Use::Left) frame.right = darkened(frame.right);
  if (verdict.use == Use::None) frame.left = frame.right = Image();
  if (verdict.use != Use::Both) frame.defect = verdict.text;
  const bool begins = verdict.fault != Fault::None && verdict.fault != last_;
  last_ = verdict.fault;
  return begins ? std::optional(verdict.text) : std::nullopt;
}

}  // namespace tolman::imaging
