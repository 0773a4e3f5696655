// SPDX-License-Identifier: BSD-3-Clause
// New corners, spread evenly over the image.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tolman::feature_stereo {

struct CornerSettings {
  int count = 500;         ///< cells of the grid, about
  double quality = 0.003;  ///< weakest, as a part of the strongest response
  int border = 12;         ///< px without corners along each edge
};

/// The strongest Shi-Tomasi corner (smaller eigenvalue of the structure tensor) of each grid cell
/// that holds none of `occupied`. In the order of cells, row by row.
std::vector<cv::Point2f> detectCorners(const cv::Mat& gray,
                                       const std::vector<cv::Point2f>& occupied,
                                       const CornerSettings& settings);

}  // namespace tolman::feature_stereo
