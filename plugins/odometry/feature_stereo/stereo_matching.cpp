// SPDX-License-Identifier: BSD-3-Clause
// Row search at half resolution, Lucas-Kanade from there.
#include "stereo_matching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace tolman::feature_stereo {
namespace {

constexpr int kRadius = 4;  // px, at half resolution; chosen, not tuned
constexpr int kSide = 2 * kRadius + 1;
constexpr int kArea = kSide * kSide;
using RowPatch = std::array<int, kArea>;

RowPatch cut(const cv::Mat& image, cv::Point centre) {
  RowPatch patch{};
  int sum = 0;
  for (int y = 0; y < kSide; ++y) {
    const uchar* row = image.ptr<uchar>(centre.y + y - kRadius) + centre.x - kRadius;
    for (int x = 0; x < kSide; ++x) {
      patch[static_cast<std::size_t>(y * kSide + x)] = row[x];
      sum += row[x];
    }
  }
  const int mean = sum / kArea;
  for (int& value : patch) value -= mean;
  return patch;
}

int difference(const RowPatch& a, const RowPatch& b) {
  int sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum;
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

float searchRow(const cv::Mat& left, const cv::Mat& right, cv::Point corner, int max_disparity) {
  const cv::Rect inside(kRadius, kRadius, left.cols - 2 * kRadius, left.rows - 2 * kRadius);
  if (!inside.contains(corner)) return kNoDisparity;
  const RowPatch patch = cut(left, corner);
  std::vector<int> costs;
  for (int d = 0; d <= max_disparity && corner.x - d >= kRadius; ++d) {
    costs.push_back(difference(patch, cut(right, {corner.x - d, corner.y})));
  }
  const auto best =
      static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
  constexpr int kWorstMean = 20;  // grey levels a pixel; chosen, not tuned
  if (costs[best] > kWorstMean * kArea || !isUnique(costs, best)) return kNoDisparity;
  return static_cast<float>(best);
}

std::vector<float> matchStereo(const FlowPyramid& left, const FlowPyramid& right,
                               const std::vector<cv::Point2f>& corners,
                               const std::vector<float>& guesses, const StereoSettings& settings) {
  const int level = std::min(1, std::min(left.levels(), right.levels()) - 1);
  const int scale = 1 << level;
  std::vector<float> disparities(corners.size(), kNoDisparity);
  std::vector<std::size_t> found;
  std::vector<cv::Point2f> from;
  std::vector<cv::Point2f> to;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    float guess = guesses[i];
    if (std::isnan(guess)) {
      const cv::Point coarse(cvRound(corners[i].x / float(scale)),
                             cvRound(corners[i].y / float(scale)));
      guess = float(scale) * searchRow(left.level(level), right.level(level), coarse,
                                       static_cast<int>(settings.max_disparity) / scale);
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

}  // namespace tolman::feature_stereo
