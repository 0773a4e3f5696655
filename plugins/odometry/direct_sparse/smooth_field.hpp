// SPDX-License-Identifier: BSD-3-Clause
// A smooth function over an image, in px: by how much the right image of a point lies below, or to
// the right of, where the calibration says. Zero for a perfectly calibrated pair.
#pragma once

#include <Eigen/Core>
#include <array>

namespace tolman::direct_sparse {

/// Products of Legendre polynomials P_i(x) P_j(y) with i + j <= 3, where x and y run from -1 to 1
/// over the image. Coefficients are in px.
struct SmoothField {
  static constexpr int kDegree = 3;
  static constexpr int kTerms = 10;
  using Terms = Eigen::Matrix<double, kTerms, 1>;

  /// i + j of each term; terms are ordered by i, then j.
  static constexpr std::array<int, kTerms> kDegrees = {0, 1, 2, 3, 1, 2, 3, 2, 3, 3};

  /// Values of the terms at pixel (u, v) of an image of this size.
  static Terms termsAt(double u, double v, int width, int height);

  /// px
  double at(double u, double v, int width, int height) const {
    return coefficients.dot(termsAt(u, v, width, height));
  }
  /// Root mean square over an image, px.
  double rms() const;
  double rmsWithoutOffset() const;

  Terms coefficients = Terms::Zero();
};

}  // namespace tolman::direct_sparse
