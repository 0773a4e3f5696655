// SPDX-License-Identifier: BSD-3-Clause
// Sums of absolute differences, for sixteen disparities at once.
#include "stereo_matching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "wide_lanes.hpp"

namespace tolman::feature_stereo {

namespace {

constexpr int kRadius = 4;  // px, at half resolution; chosen, not tuned
constexpr int kSide = 2 * kRadius + 1;
constexpr int kArea = kSide * kSide;
using SearchLanes = std::int16_t __attribute__((vector_size(2 * kLanes)));
using SearchBytes = std::uint8_t __attribute__((vector_size(kLanes)));
using RowPatch = std::array<std::int16_t, kArea>;

RowPatch cut(const PaddedImage& image, cv::Point centre) {
  RowPatch patch{};
  int sum = 0;
  for (int y = 0; y < kSide; ++y) {
    const uchar* row = image.at(centre.x - kRadius, centre.y + y - kRadius);
    for (int x = 0; x < kSide; ++x) {
      patch[static_cast<std::size_t>(y * kSide + x)] = row[x];
      sum += row[x];
    }
  }
  const int mean = sum / kArea;
  for (std::int16_t& value : patch) value = static_cast<std::int16_t>(value - mean);
  return patch;
}

TOLMAN_INLINE SearchLanes loadLanes(const uchar* p) {
  SearchBytes bytes;
  std::memcpy(&bytes, p, sizeof bytes);
  return __builtin_convertvector(bytes, SearchLanes);
}

/// Sums for the patches whose upper left pixels are `corner` and those right of it.
TOLMAN_WIDE_LANES
void compareLanes(const std::int16_t* patch, const uchar* corner, std::ptrdiff_t step,
                  std::int16_t* costs) {
  SearchLanes sum = {};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) sum += loadLanes(corner + y * step + x);  // below 2^15
  }
  std::int16_t means[kLanes];
  std::memcpy(means, &sum, sizeof sum);
  for (std::int16_t& mean : means) mean = static_cast<std::int16_t>(mean / kArea);
  SearchLanes mean;
  std::memcpy(&mean, means, sizeof mean);
  std::int32_t total[kLanes] = {};
  for (int y = 0; y < kSide; ++y) {
    SearchLanes row = {};
    for (int x = 0; x < kSide; ++x) {
      const SearchLanes difference = loadLanes(corner + y * step + x) - mean - patch[y * kSide + x];
      row += difference < 0 ? -difference : difference;  // below 9 * 510
    }
    std::int16_t lanes[kLanes];
    std::memcpy(lanes, &row, sizeof row);
    for (int lane = 0; lane < kLanes; ++lane) total[lane] += lanes[lane];
  }
  constexpr int kMost = 32767;  // far above the worst cost that is accepted
  for (int lane = 0; lane < kLanes; ++lane) {
    costs[lane] = static_cast<std::int16_t>(std::min(total[lane], kMost));
  }
}

/// Whether the cost at `best` is clearly lower than all costs more than 2 px away.
bool isUnique(const std::vector<int>& costs, std::size_t best) {
  constexpr double kClearly = 1.15;  // chosen, not tuned
  for (std::size_t d = 0; d < costs.size(); ++d) {
    const bool beside = d + 2 >= best && d <= best + 2;
    if (!beside && costs[d] <= kClearly * costs[best]) return false;
  }
  return true;
}

}  // namespace

RowSearch::RowSearch(const PaddedImage& left, const PaddedImage& right, int max_disparity)
    : left_(left), right_(right), max_disparity_(max_disparity) {}

const std::vector<int>& RowSearch::costsAt(cv::Point corner) {
  costs_.clear();
  const cv::Rect inside(kRadius, kRadius, left_.width - 2 * kRadius, left_.height - 2 * kRadius);
  if (!inside.contains(corner)) return costs_;
  const RowPatch patch = cut(left_, corner);
  const int most = std::min(max_disparity_, corner.x - kRadius);
  costs_.resize(static_cast<std::size_t>(most) + 1);
  for (int d = 0; d <= most; d += kLanes) {
    // Lanes go to the right, disparities to the left; left of the image the margin is read.
    std::int16_t lanes[kLanes];
    compareLanes(patch.data(), right_.at(corner.x - d - (kLanes - 1) - kRadius, corner.y - kRadius),
                 right_.step, lanes);
    for (int k = 0; k < kLanes && d + k <= most; ++k) {
      costs_[static_cast<std::size_t>(d + k)] = lanes[kLanes - 1 - k];
    }
  }
  return costs_;
}

float RowSearch::find(cv::Point corner) {
  if (costsAt(corner).empty()) return kNoDisparity;
  const auto best =
      static_cast<std::size_t>(std::min_element(costs_.begin(), costs_.end()) - costs_.begin());
  constexpr int kWorstMean = 20;  // grey levels a pixel; chosen, not tuned
  if (costs_[best] > kWorstMean * kArea || !isUnique(costs_, best)) return kNoDisparity;
  return static_cast<float>(best);
}

// Row search at half resolution, Lucas-Kanade from there.

std::vector<float> matchStereo(const FlowPyramid& left, const FlowPyramid& right,
                               const std::vector<cv::Point2f>& corners,
                               const std::vector<float>& guesses, const StereoSettings& settings) {
  const int level = std::min(1, std::min(left.levels(), right.levels()) - 1);
  const int scale = 1 << level;
  RowSearch search(left.padded(level), right.padded(level),
                   static_cast<int>(settings.max_disparity) / scale);
  std::vector<float> disparities(corners.size(), kNoDisparity);
  std::vector<std::size_t> found;
  std::vector<cv::Point2f> from;
  std::vector<cv::Point2f> to;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    float guess = guesses[i];
    if (std::isnan(guess)) {
      const cv::Point coarse(cvRound(corners[i].x / float(scale)),
                             cvRound(corners[i].y / float(scale)));
      guess = float(scale) * search.find(coarse);
    }
    if (std::isnan(guess)) continue;
    found.push_back(i);
    from.push_back(corners[i]);
    to.emplace_back(corners[i].x - guess, corners[i].y);
  }
  const std::vector<bool> good = trackCorners(left, right, from, to, settings.track);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const cv::Point2f shift = from[k] - to[k];
    if (good[k] && std::abs(shift.y) <= settings.epipolar && shift.x >= settings.min_disparity &&
        shift.x <= settings.max_disparity) {
      disparities[found[k]] = shift.x;
    }
  }
  return disparities;
}

namespace {

/// Nearer and farther depth of the four around a corner whose quotient still is that of one
/// surface. Chosen, not tuned.
constexpr float kEdge = 1.05F;

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

/// The values around a corner in the order of reading: upper left, upper right, lower left, lower
/// right.
using DepthsAround = std::array<float, 4>;

/// Whether all four were measured, on one surface.
bool areOneSurface(const DepthsAround& depths) {
  const auto [nearest, farthest] = std::ranges::minmax(depths);
  return nearest > 0 && std::isfinite(farthest) && farthest <= kEdge * nearest;
}

float interpolateInverse(const DepthsAround& depths, float x, float y) {
  const float upper = (1 - x) / depths[0] + x / depths[1];
  const float lower = (1 - x) / depths[2] + x / depths[3];
  return (1 - y) * upper + y * lower;
}

}  // namespace

const NamedArray* depthImage(const Frame& frame) {
  for (const char* name : {"depth.left", "depth"}) {
    const auto found = std::ranges::find(frame.sensors, name, &NamedArray::name);
    if (found != frame.sensors.end()) return &*found;
  }
  return nullptr;
}

Status requireDepth(const Frame& frame, const CameraRig& rig) {
  if (frame.left.empty()) return Status::ok();
  const NamedArray* depth = depthImage(frame);
  if (depth == nullptr) {
    return Status::unsupported(
        "the frame has no depth image; use a source of depth images (for some by its parameter "
        "'depth'), or a stereo or monocular odometry plugin");
  }
  if (depth->shape == std::vector<int>{rig.height, rig.width}) return Status::ok();
  const bool is_image = depth->shape.size() == 2;
  return Status::invalidInput(
      "the depth image has " +
      (is_image ? sizeText(depth->shape[1], depth->shape[0]) + " values"
                : std::to_string(depth->shape.size()) + " axes instead of row and column") +
      ", the image " + sizeText(rig.width, rig.height) +
      " pixels; give depth images that are registered to the image");
}

std::vector<float> depthDisparities(const NamedArray& depth,
                                    const std::vector<cv::Point2f>& corners, double fx_baseline) {
  const int height = depth.shape[0];
  const int width = depth.shape[1];
  std::vector<float> disparities(corners.size(), kNoDisparity);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const float column = std::floor(corners[i].x);
    const float row = std::floor(corners[i].y);
    if (!(column >= 0 && row >= 0 && column < float(width - 1) && row < float(height - 1)))
      continue;
    const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(column);
    const auto below = at + static_cast<std::size_t>(width);
    const std::vector<float>& z = depth.values;
    const DepthsAround depths = {z[at], z[at + 1], z[below], z[below + 1]};
    if (!areOneSurface(depths)) continue;
    disparities[i] = static_cast<float>(fx_baseline) *
                     interpolateInverse(depths, corners[i].x - column, corners[i].y - row);
  }
  return disparities;
}

namespace {

/// Whether there are measured values, and all are equal.
bool isConstant(const std::vector<float>& values) {
  const auto isMeasured = [](float value) { return value > 0; };
  const auto first = std::ranges::find_if(values, isMeasured);
  return first != values.end() && std::all_of(first, values.end(), [&](float value) {
           return !isMeasured(value) || value == *first;
         });
}

}  // namespace

FreshDepth::Kind FreshDepth::judge(const NamedArray* depth) {
  if (depth == nullptr) return Kind::Fresh;
  if (isConstant(depth->values)) return Kind::Constant;
  const bool is_measured = std::ranges::any_of(depth->values, [](float v) { return v > 0; });
  if (is_measured && depth->values == last_) return Kind::Repeated;
  last_ = depth->values;
  return Kind::Fresh;
}

}  // namespace tolman::feature_stereo
