// SPDX-License-Identifier: BSD-3-Clause
#include "depth_disparity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "stereo_matching.hpp"

namespace tolman::feature_stereo {

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
