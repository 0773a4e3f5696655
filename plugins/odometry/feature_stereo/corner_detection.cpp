// SPDX-License-Identifier: BSD-3-Clause
// Running sums over rows, in integers: exact, hence the same on every processor.
#include "corner_detection.hpp"

#include <algorithm>
#include <cmath>

#include "wide_lanes.hpp"

namespace tolman::feature_stereo {

namespace {

TOLMAN_WIDE_LANES
void combineRows(const uchar* __restrict above, const uchar* __restrict here,
                 const uchar* __restrict below, int width, std::int16_t* __restrict smooth,
                 std::int16_t* __restrict steep) {
  for (int x = 0; x < width; ++x) {
    smooth[x] = static_cast<std::int16_t>(above[x] + 2 * here[x] + below[x]);
    steep[x] = static_cast<std::int16_t>(below[x] - above[x]);
  }
}

/// Products of the derivatives by x and y.
TOLMAN_WIDE_LANES
void multiplyDerivatives(const std::int16_t* __restrict smooth,
                         const std::int16_t* __restrict steep, int width,
                         std::int32_t* __restrict xx, std::int32_t* __restrict xy,
                         std::int32_t* __restrict yy) {
  for (int x = 1; x < width - 1; ++x) {
    const auto by_x = static_cast<std::int16_t>(smooth[x + 1] - smooth[x - 1]);
    const auto by_y = static_cast<std::int16_t>(steep[x - 1] + 2 * steep[x] + steep[x + 1]);
    xx[x] = by_x * by_x;
    xy[x] = by_x * by_y;
    yy[x] = by_y * by_y;
  }
}

/// Replaces a row by sums over five columns, and in `sums` its old values by the new ones.
TOLMAN_WIDE_LANES
void replaceRow(const std::int32_t* __restrict products, int width, std::int32_t* __restrict row,
                std::int32_t* __restrict sums) {
  for (int x = 3; x < width - 3; ++x) {
    const std::int32_t sum =
        products[x - 2] + products[x - 1] + products[x] + products[x + 1] + products[x + 2];
    sums[x] += sum - row[x];
    row[x] = sum;
  }
}

TOLMAN_WIDE_LANES
void smallerEigenvalues(const std::int32_t* __restrict xx, const std::int32_t* __restrict xy,
                        const std::int32_t* __restrict yy, int width,
                        std::int32_t* __restrict response) {
  for (int x = 3; x < width - 3; ++x) {
    const auto sum = static_cast<float>(xx[x] + yy[x]);
    const auto difference = static_cast<float>(xx[x] - yy[x]);
    const auto twice = static_cast<float>(2 * xy[x]);
    const float root = std::sqrt(difference * difference + twice * twice);
    response[x] = static_cast<std::int32_t>(0.5F * (sum - root));
  }
}

}  // namespace

CornerResponse::CornerResponse(const cv::Mat& gray, int first_row)
    : gray_(gray),
      width_(static_cast<std::size_t>(gray.cols)),
      row_(first_row - kRadius),
      smooth_(2 * width_),
      products_(3 * width_),
      rows_(3 * kRows * width_),
      sums_(3 * width_),
      response_(width_) {
  for (int k = 0; k < kRows - 1; ++k) addRow();
}

void CornerResponse::addRow() {
  const int width = gray_.cols;
  combineRows(gray_.ptr<uchar>(row_ - 1), gray_.ptr<uchar>(row_), gray_.ptr<uchar>(row_ + 1), width,
              smooth_.data(), smooth_.data() + width);
  std::int32_t* const products = products_.data();
  multiplyDerivatives(smooth_.data(), smooth_.data() + width, width, products, products + width,
                      products + 2 * width);
  for (int k = 0; k < 3; ++k) {
    replaceRow(products + k * width, width, rows_.data() + (3 * (row_ % kRows) + k) * width,
               sums_.data() + k * width);
  }
  ++row_;
}

const std::int32_t* CornerResponse::next() {
  addRow();
  const std::int32_t* const sums = sums_.data();
  smallerEigenvalues(sums, sums + width_, sums + 2 * width_, gray_.cols, response_.data());
  return response_.data();
}

// Shi-Tomasi corners, one for each grid cell.

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
