// SPDX-License-Identifier: BSD-3-Clause
// Images in which landmarks are looked for: reduced to a width of about 620 px, so that the time
// does not grow with the camera's resolution.
#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgproc.hpp>

namespace tolman::landmarks {

/// Pixels of a whole image, in one direction, for one of the reduced image.
inline int reductionOf(int columns) {
  constexpr double kWidth = 620;  // px: half of KITTI's, in whose size the constants were chosen
  return std::max(1, static_cast<int>(std::lround(columns / kWidth)));
}

/// Means over squares of `factor` pixels; what is left over at the right and below is cut off.
inline cv::Mat reducedBy(int factor, const cv::Mat& gray) {
  if (factor == 1) return gray;
  const cv::Size size(gray.cols / factor, gray.rows / factor);
  cv::Mat reduced;
  if (size.empty()) return reduced;
  cv::resize(gray(cv::Rect(0, 0, size.width * factor, size.height * factor)), reduced, size, 0, 0,
             cv::INTER_AREA);
  return reduced;
}

/// The place in the whole image of a place in the reduced one, px; centres of pixels are whole.
inline cv::Point2f wholeOf(const cv::Point2f& reduced, int factor) {
  const auto f = static_cast<float>(factor);
  return {(reduced.x + 0.5F) * f - 0.5F, (reduced.y + 0.5F) * f - 0.5F};
}

}  // namespace tolman::landmarks
