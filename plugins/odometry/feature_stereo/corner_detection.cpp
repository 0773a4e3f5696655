// SPDX-License-Identifier: BSD-3-Clause
// Shi-Tomasi corners, one for each grid cell.
#include "corner_detection.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace tolman::feature_stereo {
namespace {

/// Side of square cells, px, such that the image has about `count` cells.
int cellSize(const cv::Size& size, int count) {
  return std::max(4, static_cast<int>(std::sqrt(double(size.area()) / count)));
}

cv::Mat occupiedCells(const cv::Size& grid, int cell, const std::vector<cv::Point2f>& corners) {
  cv::Mat taken = cv::Mat::zeros(grid, CV_8U);
  for (const cv::Point2f& corner : corners) {
    const int column = static_cast<int>(corner.x) / cell;
    const int row = static_cast<int>(corner.y) / cell;
    if (column >= 0 && row >= 0 && column < grid.width && row < grid.height) {
      taken.at<uchar>(row, column) = 1;
    }
  }
  return taken;
}

}  // namespace

std::vector<cv::Point2f> detectCorners(const cv::Mat& gray,
                                       const std::vector<cv::Point2f>& occupied,
                                       const CornerSettings& settings) {
  std::vector<cv::Point2f> corners;
  const int border = settings.border;
  if (gray.cols <= 2 * border || gray.rows <= 2 * border) return corners;
  cv::Mat response;
  cv::cornerMinEigenVal(gray, response, 5);  // px, side of the block; chosen, not tuned
  const cv::Rect inside(border, border, gray.cols - 2 * border, gray.rows - 2 * border);
  double strongest = 0;
  cv::minMaxLoc(response(inside), nullptr, &strongest);
  const double weakest = std::max(settings.quality * strongest, 1e-6);  // nothing in blank images

  const int cell = cellSize(gray.size(), settings.count);
  const cv::Size grid((gray.cols + cell - 1) / cell, (gray.rows + cell - 1) / cell);
  const cv::Mat taken = occupiedCells(grid, cell, occupied);
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const cv::Rect area = cv::Rect(column * cell, row * cell, cell, cell) & inside;
      if (area.empty() || taken.at<uchar>(row, column) != 0) continue;
      double best = 0;
      cv::Point place;
      cv::minMaxLoc(response(area), nullptr, &best, nullptr, &place);
      if (best < weakest) continue;
      corners.emplace_back(static_cast<float>(area.x + place.x),
                           static_cast<float>(area.y + place.y));
    }
  }
  return corners;
}

}  // namespace tolman::feature_stereo
