// SPDX-License-Identifier: BSD-3-Clause
#include "engine/camera_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

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
constexpr double kTurns = 2;         // px between two frames
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

/// Whether the right image belongs to the left one of the frame before. Where the camera turns to
/// one side, a late image looks as if both were exchanged and fits the left one before it; to the
/// other side both fit, and what was seen in a turn to the first side decides.
bool FrameCheck::isLate(const StereoMeasure& measure, const GrayHalf& right) {
  const StereoFault now = faultOf(measure);
  if (left_.empty() || (now != StereoFault::Exchanged && !late_)) return false;
  const StereoMeasure before = measureStereo(grayHalf(left_), right);
  if (before.matched < kCertain) return false;
  const StereoFault then = faultOf(before);
  if (then == StereoFault::Exchanged && now == StereoFault::None) late_ = false;
  if (then == StereoFault::None && now == StereoFault::Exchanged) late_ = true;
  const bool turns = std::fabs(before.to_left - measure.to_left) > kTurns;
  return then == StereoFault::None && (now == StereoFault::Exchanged || (late_ && turns));
}

/// The present fault of the pair. A fault that is measured with few matches counts only if two
/// measures in succession find it. It ends after kSoundAgain measures without a fault.
StereoFault FrameCheck::stereoFault(const Frame& frame) {
  if (frame.right.empty() || until_measured_-- > 0) return fault_;
  const GrayHalf right = grayHalf(frame.right);
  const StereoMeasure measure = measureStereo(grayHalf(frame.left), right);
  StereoFault measured = faultOf(measure);
  const bool late = isLate(measure, right);
  if (late) measured = StereoFault::OtherTime;
  if (rows_.size() < kMostRows) {
    rows_.insert(rows_.end(), measure.rows.begin(), measure.rows.end());
  }
  const bool certain = measure.matched >= kCertain || measured == last_measured_;
  last_measured_ = measured;
  if (measured != StereoFault::None) {
    if (certain) fault_ = measured;
    if (certain) {
      stereo_text_ = late ? "the right image belongs to the left one of the frame before; are both "
                            "exposed at the same time, and paired by their times?"
                          : faultText(measured, measure);
    }
    sound_measures_ = 0;
  } else if (++sound_measures_ >= kSoundAgain) {
    fault_ = StereoFault::None;
  }
  const bool settled = fault_ == StereoFault::None && measured == StereoFault::None && !late_;
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

namespace {

// Lengths in pixels of the half images.
constexpr int kRadius = 5;  // rows of a patch above and below its middle
constexpr int kPatchWidth = 16;
constexpr int kFarLeft = 64;   // largest disparity
constexpr int kFarRight = 16;  // largest disparity of the wrong sign
constexpr int kRows = 6;       // rows that are searched above and below
constexpr int kBorder = kPatchWidth / 2 + kRows + 1;
constexpr int kColumnsOfCells = 12;
constexpr int kRowsOfCells = 5;

constexpr double kMostExchanged = 0.6;  // share of the matches

constexpr int kPatchArea = kPatchWidth * (2 * kRadius + 1);
constexpr double kWeakestCorner = 40;      // smaller eigenvalue of the structure tensor, per pixel
constexpr double kLargestDifference = 14;  // grey levels per pixel
constexpr double kDistinct = 0.75;         // best difference relative to that of any distant place

struct Corner {
  int x = 0;
  int y = 0;
  double strength = 0;
};

/// Smaller eigenvalue of the structure tensor of the patch, per pixel (Shi and Tomasi 1994).
double cornerStrength(const GrayHalf& image, int x, int y) {
  constexpr int kWindow = 3;
  double xx = 0;
  double yy = 0;
  double xy = 0;
  for (int r = y - kWindow; r <= y + kWindow; ++r) {
    const std::uint8_t* above = image.row(r - 1);
    const std::uint8_t* row = image.row(r);
    const std::uint8_t* below = image.row(r + 1);
    for (int c = x - kWindow; c <= x + kWindow; ++c) {
      const int dx = row[c + 1] - row[c - 1];
      const int dy = below[c] - above[c];
      xx += dx * dx;
      yy += dy * dy;
      xy += dx * dy;
    }
  }
  const double mean = 0.5 * (xx + yy);
  return (mean - std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy)) /
         ((2 * kWindow + 1) * (2 * kWindow + 1));
}

/// The strongest corner of each cell of a grid.
std::vector<Corner> findCorners(const GrayHalf& image) {
  std::vector<Corner> corners;
  const int width = image.width - 2 * kBorder;
  const int height = image.height - 2 * kBorder;
  if (width < kColumnsOfCells || height < kRowsOfCells) return corners;
  for (int cell = 0; cell < kColumnsOfCells * kRowsOfCells; ++cell) {
    const int column = cell % kColumnsOfCells;
    const int row = cell / kColumnsOfCells;
    Corner best;
    for (int y = kBorder + row * height / kRowsOfCells;
         y < kBorder + (row + 1) * height / kRowsOfCells; y += 3) {
      for (int x = kBorder + column * width / kColumnsOfCells;
           x < kBorder + (column + 1) * width / kColumnsOfCells; x += 3) {
        const double strength = cornerStrength(image, x, y);
        if (strength > best.strength) best = {x, y, strength};
      }
    }
    if (best.strength > kWeakestCorner) corners.push_back(best);
  }
  return corners;
}

/// Sum of absolute differences of two patches. The compiler uses one instruction per row.
int difference(const GrayHalf& left, const Corner& corner, const GrayHalf& right, int x, int y) {
  int sum = 0;
  for (int r = -kRadius; r <= kRadius; ++r) {
    const std::uint8_t* a = left.row(corner.y + r) + corner.x - kPatchWidth / 2;
    const std::uint8_t* b = right.row(y + r) + x - kPatchWidth / 2;
    for (int c = 0; c < kPatchWidth; ++c) sum += std::abs(b[c] - a[c]);
  }
  return sum;
}

int meanOf(const GrayHalf& image) {
  const auto sum = std::accumulate(image.pixels.begin(), image.pixels.end(), std::int64_t{0});
  return static_cast<int>(sum / static_cast<std::int64_t>(image.pixels.size()));
}

/// The image as bright as `other`.
GrayHalf asBright(GrayHalf image, const GrayHalf& other) {
  const int brighter = meanOf(other) - meanOf(image);
  for (std::uint8_t& pixel : image.pixels) {
    pixel = static_cast<std::uint8_t>(std::clamp(pixel + brighter, 0, 255));
  }
  return image;
}

struct RowMatch {
  double down = 0;     ///< rows, in pixels of the half images
  double to_left = 0;  ///< disparity, likewise
};

std::optional<RowMatch> findMatch(const GrayHalf& left, const Corner& corner,
                                  const GrayHalf& right) {
  const int begin = std::max(corner.x - kFarLeft, kPatchWidth / 2);
  const int end = std::min(corner.x + kFarRight, right.width - kPatchWidth / 2);
  const int width = end - begin + 1;
  std::vector<int> costs(static_cast<std::size_t>(width) * (2 * kRows + 1));
  const auto cost = [&](int x, int down) -> int& {
    return costs[static_cast<std::size_t>((down + kRows) * width + x - begin)];
  };
  int best_x = begin;
  int best_down = -kRows;
  for (int down = -kRows; down <= kRows; ++down) {
    for (int x = begin; x <= end; ++x) {
      cost(x, down) = difference(left, corner, right, x, corner.y + down);
      if (cost(x, down) < cost(best_x, best_down)) best_x = x, best_down = down;
    }
  }
  const int best = cost(best_x, best_down);
  const bool inside = std::abs(best_down) < kRows && best_x > begin && best_x < end;
  if (!inside || best > kLargestDifference * kPatchArea) return std::nullopt;
  for (int down = -kRows; down <= kRows; ++down) {
    for (int x = begin; x <= end; ++x) {
      if (std::abs(x - best_x) <= 2 && std::abs(down - best_down) <= 2) continue;
      if (best > kDistinct * cost(x, down)) return std::nullopt;
    }
  }
  // The minimum of a parabola through three differences.
  const double above = cost(best_x, best_down - 1);
  const double below = cost(best_x, best_down + 1);
  const double curvature = above - 2 * best + below;
  const double rest = curvature > 0 ? std::clamp(0.5 * (above - below) / curvature, -0.5, 0.5) : 0;
  return RowMatch{best_down + rest, static_cast<double>(corner.x - best_x)};
}

}  // namespace

GrayHalf grayHalf(const Image& image) {
  GrayHalf half{image.width() / 2, image.height() / 2, {}};
  half.pixels.resize(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  const int step = bytesPerPixel(image.format());
  const int channel = step == 3 ? 1 : 0;
  std::uint8_t* out = half.pixels.data();
  for (int r = 0; r < half.height; ++r) {
    const std::uint8_t* a = image.row(2 * r) + channel;
    const std::uint8_t* b = image.row(2 * r + 1) + channel;
    for (int c = 0; c < half.width; ++c, a += 2 * step, b += 2 * step) {
      *out++ = static_cast<std::uint8_t>((a[0] + a[step] + b[0] + b[step] + 2) / 4);
    }
  }
  return half;
}

double quantile(std::vector<double> values, double share) {
  const auto nth =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

StereoMeasure measureStereo(const GrayHalf& left, const GrayHalf& right) {
  StereoMeasure measure;
  if (left.width != right.width || left.height != right.height) return measure;
  const std::vector<Corner> corners = findCorners(left);
  if (corners.empty()) return measure;
  measure.corners = static_cast<int>(corners.size());
  const GrayHalf bright = asBright(left, right);
  std::vector<double> down, to_left;
  int exchanged = 0;
  for (const Corner& corner : corners) {
    const auto match = findMatch(bright, corner, right);
    if (!match) continue;
    down.push_back(2 * match->down);
    to_left.push_back(2 * match->to_left);
    exchanged += match->to_left < -1 ? 1 : 0;
  }
  measure.matched = static_cast<int>(down.size());
  if (down.empty()) return measure;
  measure.rows = down;
  measure.rows_low = quantile(down, 0.5);
  measure.to_left = quantile(to_left, 0.5);
  measure.share_exchanged = static_cast<double>(exchanged) / measure.matched;
  for (double& d : down) d = std::fabs(d - measure.rows_low);
  measure.spread = quantile(down, 0.8);
  return measure;
}

/// The limits were chosen on kitti_clips/06 with synthetic faults: sound pairs have a spread of at
/// most 0.5 px, strongly blurred ones of 2.8 px, and a right image that is 0.1 s late one of 3.5
/// to 6.8 px.
StereoFault faultOf(const StereoMeasure& measure) {
  constexpr int kMin = 8;             // matches
  constexpr double kApart = 1.2;      // px
  constexpr double kScattered = 3.0;  // px
  if (measure.matched < kMin) return StereoFault::None;
  // Tested first, because on a highway a late right image also has most corners on the wrong side.
  if (measure.spread > kScattered) return StereoFault::OtherTime;
  if (measure.share_exchanged > kMostExchanged) return StereoFault::Exchanged;
  return std::fabs(measure.rows_low) > kApart ? StereoFault::RowsApart : StereoFault::None;
}

std::string faultText(StereoFault fault, const StereoMeasure& measure) {
  switch (fault) {
    case StereoFault::RowsApart:
      return fmt::format(
          "the right image is {:.1f} px {}; are the images rectified, by the "
          "calibration of these cameras?",
          std::fabs(measure.rows_low), measure.rows_low > 0 ? "low" : "high");
    case StereoFault::Exchanged:
      return "left and right image are exchanged; exchange the two folders, topics or cameras of "
             "the calibration";
    case StereoFault::OtherTime:
      return fmt::format(
          "the rows of left and right image do not belong together (differences of {:.1f} px); are "
          "both exposed at the same time, and rectified?",
          measure.spread);
    case StereoFault::None:
      break;
  }
  return "";
}

}  // namespace tolman::engine
