// SPDX-License-Identifier: BSD-3-Clause
// Shi-Tomasi corners, one for each grid cell.
#include "corner_detection.hpp"

#include <algorithm>
#include <cmath>

#include "corner_response.hpp"
#include "wide_lanes.hpp"

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

/// The strongest responses of one row of cells, for each column of pixels.
struct Band {
  std::vector<std::int32_t> best;
  std::vector<std::int32_t> row;  ///< of the image, where it is

  explicit Band(int width)
      : best(static_cast<std::size_t>(width)), row(static_cast<std::size_t>(width)) {}
};

TOLMAN_WIDE_LANES
void keepStrongest(const std::int32_t* __restrict response, int row, int first, int end,
                   std::int32_t* __restrict best, std::int32_t* __restrict rows) {
  for (int x = first; x < end; ++x) {
    const bool stronger = response[x] > best[x];
    best[x] = stronger ? response[x] : best[x];
    rows[x] = stronger ? row : rows[x];
  }
}

struct Corner {
  std::int32_t response = 0;
  cv::Point place;
};

/// The strongest corner of columns [first, end); of equal ones the uppermost, then the leftmost.
Corner strongestOf(const Band& band, int first, int end) {
  Corner corner;
  for (int x = first; x < end; ++x) {
    const auto i = static_cast<std::size_t>(x);
    if (band.best[i] > corner.response ||
        (band.best[i] == corner.response && band.row[i] < corner.place.y)) {
      corner = {band.best[i], {x, band.row[i]}};
    }
  }
  return corner;
}

}  // namespace

std::vector<cv::Point2f> detectCorners(const cv::Mat& gray,
                                       const std::vector<cv::Point2f>& occupied,
                                       const CornerSettings& settings) {
  const int border = std::max(settings.border, CornerResponse::kReach);
  if (gray.cols <= 2 * border || gray.rows <= 2 * border) return {};
  const int cell = cellSize(gray.size(), settings.count);
  const cv::Size grid((gray.cols + cell - 1) / cell, (gray.rows + cell - 1) / cell);
  const cv::Mat taken = occupiedCells(grid, cell, occupied);
  CornerResponse responses(gray, border);
  std::vector<Corner> corners;
  std::int32_t strongest = 0;
  Band band(gray.cols);
  for (int row = 0; row < grid.height; ++row) {
    std::fill(band.best.begin(), band.best.end(), 0);
    const int end = std::min((row + 1) * cell, gray.rows - border);
    for (int y = std::max(row * cell, border); y < end; ++y) {
      keepStrongest(responses.next(), y, border, gray.cols - border, band.best.data(),
                    band.row.data());
    }
    for (int column = 0; column < grid.width; ++column) {
      const Corner corner = strongestOf(band, std::max(column * cell, border),
                                        std::min((column + 1) * cell, gray.cols - border));
      strongest = std::max(strongest, corner.response);
      if (taken.at<uchar>(row, column) == 0) corners.push_back(corner);
    }
  }
  constexpr double kWeakest = 26;  // nothing in blank images
  const double weakest = std::max(settings.quality * strongest, kWeakest);
  std::vector<cv::Point2f> places;
  for (const Corner& corner : corners) {
    if (corner.response >= weakest) places.emplace_back(corner.place);
  }
  return places;
}

}  // namespace tolman::feature_stereo
