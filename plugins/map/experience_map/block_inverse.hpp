// SPDX-License-Identifier: BSD-3-Clause
// The inverse of a small symmetric positive definite matrix.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace tolman::experience_map {

/// Inverts in place by Gauss-Jordan elimination without pivoting, which a positive definite matrix
/// does not need. Adds
/// the logarithm of the determinant to `log_determinant`. False when the matrix is not positive
/// definite; it is then left in an unspecified state.
template <int kSize>
bool invertPositive(Eigen::Matrix<double, kSize, kSize>& matrix, double& log_determinant) {
  double determinant = 1;
  for (int k = 0; k < kSize; ++k) {
    const double pivot = matrix(k, k);
    if (!(pivot > 0)) return false;
    determinant *= pivot;
    const Eigen::Matrix<double, kSize, 1> column = matrix.col(k) / pivot;
    const Eigen::Matrix<double, 1, kSize> row = matrix.row(k);
    matrix.noalias() -= column * row;
    matrix.row(k) = row / pivot;
    matrix.col(k) = -column;
    matrix(k, k) = 1 / pivot;
  }
  log_determinant += std::log(determinant);
  return std::isfinite(determinant) && determinant > 0;
}

}  // namespace tolman::experience_map
