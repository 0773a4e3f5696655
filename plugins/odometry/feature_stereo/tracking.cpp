// SPDX-License-Identifier: BSD-3-Clause
// Lucas-Kanade from coarse to fine, and back on the finest level.
#include "tracking.hpp"

#include <algorithm>

#include "patch_alignment.hpp"

namespace tolman::feature_stereo {
namespace {

// px, of the last step; chosen, not tuned.
constexpr float kTolerance = 0.01F;
constexpr float kCoarseTolerance = 0.05F;

bool insideImage(const cv::Point2f& point, const cv::Size& size) {
  // px of the centre from the border; the patch may exceed it. Chosen, not tuned.
  constexpr float kMargin = 3;
  return point.x >= kMargin && point.y >= kMargin &&
         point.x < static_cast<float>(size.width) - kMargin &&
         point.y < static_cast<float>(size.height) - kMargin;
}

/// Moves `to` level by level. Where a coarse level has no texture, the next one starts from the
/// same place.
bool follow(const FlowPyramid& from_image, const FlowPyramid& to_image, const cv::Point2f& from,
            cv::Point2f& to, int levels, Patch& patch) {
  for (int level = levels - 1; level >= 0; --level) {
    const float scale = 1.0F / static_cast<float>(1 << level);
    cv::Point2f place = scale * to;
    const bool found =
        patch.take(from_image.padded(level), scale * from) &&
        patch.align(to_image.padded(level), place, level == 0 ? kTolerance : kCoarseTolerance);
    if (found) to = place / scale;
    if (!found && level == 0) return false;
  }
  return true;
}

}  // namespace

std::vector<bool> trackCorners(const FlowPyramid& from_image, const FlowPyramid& to_image,
                               const std::vector<cv::Point2f>& from, std::vector<cv::Point2f>& to,
                               const TrackSettings& settings) {
  std::vector<bool> good(from.size(), false);
  if (from.empty()) return good;
  const int levels = std::min({settings.levels, from_image.levels(), to_image.levels()});
  Patch patch(settings.window);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!follow(from_image, to_image, from[i], to[i], levels, patch)) continue;
    if (!insideImage(to[i], to_image.size())) continue;
    // A track that went astray seldom comes back to where it started, even if it starts there. From
    // coarse to fine the check would find a few more, at a tenth more time and without a gain.
    cv::Point2f back = from[i];
    if (!follow(to_image, from_image, to[i], back, 1, patch)) continue;
    good[i] = cv::norm(back - from[i]) <= settings.consistency;
  }
  return good;
}

}  // namespace tolman::feature_stereo
