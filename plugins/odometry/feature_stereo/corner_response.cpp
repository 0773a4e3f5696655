// SPDX-License-Identifier: BSD-3-Clause
// Running sums over rows, in integers: exact, hence the same on every processor.
#include "corner_response.hpp"

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

}  // namespace tolman::feature_stereo
