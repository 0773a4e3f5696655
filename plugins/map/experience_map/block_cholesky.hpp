// SPDX-License-Identifier: BSD-3-Clause
// The factorisation L D L' of a sparse symmetric positive definite matrix of small square blocks.
// The order of elimination is found on the pattern of blocks (approximate minimum degree), which is
// kSize^2 times smaller than that of numbers, and kept for all factorisations. All arithmetic is
// products of blocks, in a fixed order, so results are the same bit by bit.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tolman::experience_map {

/// Inverts a small positive definite matrix in place, by Gauss-Jordan elimination without pivoting,
/// which it does not need. Adds the logarithm of the determinant to `log_determinant`. False when
/// it is not positive definite; it is then left in an unspecified state.
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

template <int kSize>
class BlockCholesky {
 public:
  using Block = Eigen::Matrix<double, kSize, kSize>;
  /// Row and column of a block that may be nonzero, row > column. Entries may repeat.
  using Entry = std::pair<std::size_t, std::size_t>;

  BlockCholesky() = default;
  BlockCholesky(std::size_t rows, const std::vector<Entry>& entries);

  void setZero();
  /// The diagonal block of the row; the caller adds to it before factorise().
  Block& diagonal(std::size_t row) { return diagonal_[step_of_[row]]; }
  /// Adds to the block of entry `k` of the constructor.
  void add(std::size_t k, const Block& block);

  /// False when the matrix is not positive definite. Overwrites the matrix.
  bool factorise();
  /// `x` has a row of blocks for each row of the matrix.
  template <int kColumns>
  void solve(std::vector<Eigen::Matrix<double, kSize, kColumns>>& x) const;
  /// Logarithm of the determinant of the factorised matrix.
  double logDeterminant() const { return log_determinant_; }

 private:
  struct Place {
    std::size_t block;
    bool transposed;
  };
  void findOrder(const std::vector<Entry>& entries);
  void findFill(const std::vector<Entry>& entries);
  std::size_t placeOf(std::size_t row, std::size_t column) const;
  void spread(std::size_t step);

  std::vector<std::size_t> step_of_;  ///< position of each row in the order of elimination
  // Below, rows and columns are positions in that order.
  std::vector<std::size_t> begin_;  ///< first index of each column in rows_ and blocks_
  std::vector<std::size_t> rows_;   ///< rows below the diagonal, ascending in each column
  std::vector<Place> places_;       ///< where each entry of the constructor is stored
  std::vector<Block> diagonal_;     ///< after factorise(): the inverse of D
  std::vector<Block> blocks_;       ///< after factorise(): L
  std::vector<Block> column_;       ///< the column that is eliminated, before its division by D
  double log_determinant_ = 0;
};

extern template class BlockCholesky<3>;
extern template class BlockCholesky<6>;

}  // namespace tolman::experience_map
