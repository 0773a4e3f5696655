// SPDX-License-Identifier: BSD-3-Clause
// How well a place can be tracked: the smaller eigenvalue of its structure tensor (Shi and Tomasi,
// CVPR 1994).
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace tolman::feature_stereo {

/// Computes responses row by row, from top to bottom.
class CornerResponse {
 public:
  static constexpr int kRadius = 2;  ///< px, of the block that is summed; chosen, not tuned
  static constexpr int kReach = kRadius + 2;  ///< px around a pixel that its response depends on

  /// `first_row`: that of the first call of next(), at least kReach. The image must exist as long
  /// as this.
  CornerResponse(const cv::Mat& gray, int first_row);

  /// The responses of a row, indexed by column, from kReach on to kReach before the end:
  /// eigenvalues of the sum over the block, in squared units of Sobel's derivatives (8 for a grey
  /// level per px).
  const std::int32_t* next();

 private:
  static constexpr int kRows = 2 * kRadius + 1;
  void addRow();

  const cv::Mat& gray_;
  std::size_t width_;
  int row_;                           ///< whose derivatives are added next
  std::vector<std::int16_t> smooth_;  ///< sums of three rows; their differences follow
  std::vector<std::int32_t> products_;
  std::vector<std::int32_t> rows_;  ///< for each of the last kRows: products, summed across
  std::vector<std::int32_t> sums_;  ///< of these rows
  std::vector<std::int32_t> response_;
};

// Detects new corners, distributed evenly over the image (Shi and Tomasi, CVPR 1994).

struct CornerSettings {
  int count = 500;         ///< approximate number of grid cells
  double quality = 0.003;  ///< smallest response relative to the strongest one
  int border = 11;         ///< px without corners along each edge: half a patch and 4
};

/// The strongest Shi-Tomasi corner (smaller eigenvalue of the structure tensor) of each grid cell
/// that holds none of `occupied`. In the order of cells, row by row.
std::vector<cv::Point2f> detectCorners(const cv::Mat& gray,
                                       const std::vector<cv::Point2f>& occupied,
                                       const CornerSettings& settings);

}  // namespace tolman::feature_stereo
