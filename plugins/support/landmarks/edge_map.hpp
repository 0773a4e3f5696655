// SPDX-License-Identifier: BSD-3-Clause
// Strength of edges in six directions, on a grid of cells of 2 x 2 px of the reduced image. The
// sign of edges and the level of light have no effect, as the image is replaced by its logarithm
// (histograms of oriented gradients, Dalal and Triggs 2005; square root as by Arandjelovic and
// Zisserman 2012).
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace tolman::landmarks {

/// Grey levels that are added before the logarithm of an image is taken, which is nearly linear
/// below. Chosen on the town's 05 and 06 with their second passes by night.
inline constexpr float kDarkLevel = 8;

class EdgeMap {
 public:
  static constexpr int kDirections = 6;
  static constexpr int kMargin = 6;     ///< cells of strength 0 around the image
  static constexpr int kReadable = 16;  ///< values that may be read after the last one

  EdgeMap() = default;  ///< without cells
  explicit EdgeMap(const cv::Mat& gray) { compute(gray); }

  /// Of a grey image, which is reduced to a width of about 620 px. Uses its memory again: new
  /// memory for each image takes as long as the computation.
  void compute(const cv::Mat& gray);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// px of the image for one of the reduced image.
  int factor() const { return factor_; }
  /// The strength in a direction at a cell, which may be up to kMargin outside; the next columns
  /// follow.
  const float* at(int direction, int row, int column) const {
    return planes_.data() + static_cast<std::size_t>(direction) * plane_ + indexOf(row, column);
  }
  /// Squares of all strengths at a cell, summed over the directions.
  float energyAt(int row, int column) const { return energy_[indexOf(row, column)]; }
  /// Distance of at()'s values from one row, and from one direction, to the next.
  std::ptrdiff_t rowStride() const { return stride_; }
  std::ptrdiff_t directionStride() const { return static_cast<std::ptrdiff_t>(plane_); }
  cv::Point2f cellOf(const cv::Point2f& pixel) const;
  cv::Point2f pixelOf(const cv::Point2f& cell) const;

 private:
  std::size_t indexOf(int row, int column) const {
    return static_cast<std::size_t>((row + kMargin) * stride_ + column + kMargin);
  }
  void addEdges(const cv::Mat& light);
  void smoothen();

  int factor_ = 1;
  int columns_ = 0;
  int rows_ = 0;
  int stride_ = 0;
  std::size_t plane_ = 0;  ///< values of a direction
  std::vector<float> planes_;
  std::vector<float> energy_;
};

}  // namespace tolman::landmarks
