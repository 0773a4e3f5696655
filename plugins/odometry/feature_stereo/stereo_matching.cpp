// SPDX-License-Identifier: BSD-3-Clause
// Row search at half resolution, Lucas-Kanade from there.
#include "stereo_matching.hpp"

#include <algorithm>
#include <cmath>

#include "row_search.hpp"

namespace tolman::feature_stereo {

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

}  // namespace tolman::feature_stereo
