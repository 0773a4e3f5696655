// SPDX-License-Identifier: BSD-3-Clause
#include "edge_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "landmarks.hpp"
#include "wide_lanes.hpp"

namespace tolman::landmarks {
namespace {

// Chosen on the town's route 06 with its second pass by night.
constexpr double kImageBlur = 0.8;      // px, standard deviation: against noise
constexpr double kStrengthBlur = 1.25;  // cells, standard deviation

/// Logarithm of the reduced image, without its noise.
cv::Mat lightOf(const cv::Mat& reduced) {
  std::array<float, 256> logarithm;
  for (std::size_t v = 0; v < logarithm.size(); ++v) {
    logarithm[v] = std::log(static_cast<float>(v) + kDarkLevel);
  }
  cv::Mat light;
  cv::LUT(reduced, cv::Mat(1, 256, CV_32F, logarithm.data()), light);
  cv::GaussianBlur(light, light, cv::Size(), kImageBlur);
  return light;
}

/// Gradients of a row of pixels: first those of the left pixels of all cells, then of the right.
struct RowOfEdges {
  explicit RowOfEdges(int cells)
      : across(2 * static_cast<std::size_t>(cells)),
        down(across),
        strength(across),
        scale(across) {}

  std::vector<float> across;
  std::vector<float> down;
  std::vector<float> strength;
  std::vector<float> scale;  ///< 4 / strength
};

/// The first and the last pixel have no gradient.
TOLMAN_WIDE_LANES void gradientsOf(const float* above, const float* row, const float* below,
                                   int cells, float* across, float* down) {
  for (int c = 1; c < cells; ++c) {
    across[c] = row[2 * c + 1] - row[2 * c - 1];
    down[c] = below[2 * c] - above[2 * c];
  }
  for (int c = 0; c + 1 < cells; ++c) {
    across[cells + c] = row[2 * c + 2] - row[2 * c];
    down[cells + c] = below[2 * c + 1] - above[2 * c + 1];
  }
}

TOLMAN_WIDE_LANES void strengthsOf(const float* across, const float* down, int count,
                                   float* strength, float* scale) {
  constexpr float kLeast = 1e-6F;  // keeps the division finite
  for (int i = 0; i < count; ++i) {
    strength[i] = std::sqrt(across[i] * across[i] + down[i] * down[i]) + kLeast;
    scale[i] = 4 / strength[i];
  }
}

/// Adds to each cell its two pixels' edges along a direction (cosine, sine): all of the strength
/// there, none at 30 degrees from it and beyond.
TOLMAN_WIDE_LANES void addDirection(const float* across, const float* down, const float* strength,
                                    const float* scale, int cells, float cosine, float sine,
                                    float* sums) {
  for (int c = 0; c < cells; ++c) {
    const float left = across[c] * cosine + down[c] * sine;
    const float right = across[cells + c] * cosine + down[cells + c] * sine;
    const float of_left = left * left * scale[c] - 3 * strength[c];
    const float of_right = right * right * scale[cells + c] - 3 * strength[cells + c];
    sums[c] += (of_left > 0 ? of_left : 0) + (of_right > 0 ? of_right : 0);
  }
}

}  // namespace

void EdgeMap::compute(const cv::Mat& gray) {
  factor_ = reductionOf(gray.cols);
  const cv::Mat light = lightOf(reducedBy(factor_, gray));
  columns_ = light.cols / 2;
  rows_ = light.rows / 2;
  stride_ = columns_ + 2 * kMargin;
  plane_ = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(rows_ + 2 * kMargin);
  planes_.assign(plane_ * kDirections + kReadable, 0);
  energy_.assign(plane_, 0);
  addEdges(light);
  smoothen();
}

void EdgeMap::addEdges(const cv::Mat& light) {
  RowOfEdges edges(columns_);
  for (int y = 1; y + 1 < light.rows && y < 2 * rows_; ++y) {
    gradientsOf(light.ptr<float>(y - 1), light.ptr<float>(y), light.ptr<float>(y + 1), columns_,
                edges.across.data(), edges.down.data());
    strengthsOf(edges.across.data(), edges.down.data(), 2 * columns_, edges.strength.data(),
                edges.scale.data());
    for (int k = 0; k < kDirections; ++k) {
      const double angle = (k + 0.5) * std::numbers::pi / kDirections;
      addDirection(edges.across.data(), edges.down.data(), edges.strength.data(),
                   edges.scale.data(), columns_, static_cast<float>(std::cos(angle)),
                   static_cast<float>(std::sin(angle)),
                   planes_.data() + static_cast<std::size_t>(k) * plane_ + indexOf(y / 2, 0));
    }
  }
}

/// Spreads the strengths over the neighbouring cells, and takes the square root.
void EdgeMap::smoothen() {
  for (int k = 0; k < kDirections; ++k) {
    float* plane = planes_.data() + static_cast<std::size_t>(k) * plane_;
    cv::Mat inside(rows_, columns_, CV_32F, plane + indexOf(0, 0),
                   static_cast<std::size_t>(stride_) * sizeof(float));
    cv::GaussianBlur(inside, inside, cv::Size(), kStrengthBlur, 0,
                     cv::BORDER_REFLECT_101 | cv::BORDER_ISOLATED);
    for (std::size_t i = 0; i < plane_; ++i) {
      energy_[i] += plane[i];
      plane[i] = std::sqrt(plane[i]);
    }
  }
}

cv::Point2f EdgeMap::cellOf(const cv::Point2f& pixel) const {
  const auto f = static_cast<float>(factor_);
  return {((pixel.x + 0.5F) / f - 1) / 2, ((pixel.y + 0.5F) / f - 1) / 2};
}

cv::Point2f EdgeMap::pixelOf(const cv::Point2f& cell) const {
  const auto f = static_cast<float>(factor_);
  return {(2 * cell.x + 1) * f - 0.5F, (2 * cell.y + 1) * f - 0.5F};
}

}  // namespace tolman::landmarks
