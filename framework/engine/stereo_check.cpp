// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <vector>

#include "engine/camera_check.hpp"

namespace tolman::engine {
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
  std::vector<double> down;
  int exchanged = 0;
  for (const Corner& corner : corners) {
    const auto match = findMatch(bright, corner, right);
    if (!match) continue;
    down.push_back(2 * match->down);
    exchanged += match->to_left < -1 ? 1 : 0;
  }
  measure.matched = static_cast<int>(down.size());
  if (down.empty()) return measure;
  measure.rows = down;
  measure.rows_low = quantile(down, 0.5);
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
      if (measure.share_exchanged > kMostExchanged) {
        return "the right image belongs to the left one of the frame before; are both exposed at "
               "the "
               "same time, and paired by their times?";
      }
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
