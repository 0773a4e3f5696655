// SPDX-License-Identifier: BSD-3-Clause
// Finds where a patch of one image is seen in another, to a fraction of a pixel, from a good guess
// (Lucas and Kanade 1981, with the derivatives of the patch: Baker and Matthews, IJCV 2004).
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "tracking.hpp"

namespace tolman::feature_stereo {

/// Fixed-point unit of a grey level.
constexpr int kGrayOne = 8;

/// The grey levels of `rows` rows of `columns` (a multiple of kLanes) pixels at a fraction of a
/// pixel right of and below `corner`. The fractions have 7 and 15 bits.
void interpolate(const uchar* corner, std::ptrdiff_t step, int rows, int columns, int right,
                 int below, std::int16_t* gray);

/// A patch with its derivatives.
class Patch {
 public:
  explicit Patch(int side);

  /// Copies the pixels around `centre`; false if they have no texture or lie outside the image.
  bool take(const PaddedImage& image, const cv::Point2f& centre);
  /// Moves `centre` to where the patch is seen, until a step is shorter than `tolerance`, px; false
  /// if it leaves the image.
  bool align(const PaddedImage& image, cv::Point2f& centre, float tolerance);

 private:
  int side_;
  int columns_;                     ///< side_ in lanes; the derivatives beyond side_ are 0
  std::vector<std::int16_t> gray_;  ///< in 1 / kGrayOne grey levels
  std::vector<std::int16_t> by_x_;  ///< in 1 / kGrayOne grey levels per px
  std::vector<std::int16_t> by_y_;
  std::vector<std::int16_t> buffer_;
  std::vector<std::int16_t> sums_;
  std::vector<std::int16_t> steps_;
  double inverse_[3] = {0, 0, 0};  ///< xx, xy, yy of the inverse structure tensor
};

}  // namespace tolman::feature_stereo
