// SPDX-License-Identifier: BSD-3-Clause
// Detects new corners, distributed evenly over the image (Shi and Tomasi, CVPR 1994).
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tolman::feature_stereo {

struct CornerSettings {
  int count = 500;         ///< approximate number of grid cells
  double quality = 0.003;  ///< smallest response relative to the strongest one
  int border = 12;         ///< px without corners along each edge; chosen, not tuned
};

/// The strongest Shi-Tomasi corner (smaller eigenvalue of the structure tensor) of each grid cell
/// that holds none of `occupied`. In the order of cells, row by row.
std::vector<cv::Point2f> detectCorners(const cv::Mat& gray,
                                       const std::vector<cv::Point2f>& occupied,
                                       const CornerSettings& settings);

}  // namespace tolman::feature_stereo
