// SPDX-License-Identifier: BSD-3-Clause
// Right-looking factorisation: each column, once divided by its D, is subtracted from the columns
// of its rows.
#include "block_cholesky.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>

namespace tolman::experience_map {

template <int kSize>
BlockCholesky<kSize>::BlockCholesky(std::size_t rows, const std::vector<Entry>& entries)
    : step_of_(rows), begin_(rows + 1), diagonal_(rows) {
  findOrder(entries);
  findFill(entries);
  blocks_.resize(rows_.size());
  for (const auto& [row, column] : entries) {
    const auto [first, last] = std::minmax(step_of_[row], step_of_[column]);
    places_.push_back({placeOf(last, first), step_of_[row] < step_of_[column]});
  }
}

template <int kSize>
void BlockCholesky<kSize>::findOrder(const std::vector<Entry>& entries) {
  const auto size = static_cast<Eigen::Index>(step_of_.size());
  std::vector<Eigen::Triplet<double>> pattern;
  pattern.reserve(entries.size() + step_of_.size());
  for (const auto& [row, column] : entries) {
    pattern.emplace_back(static_cast<int>(row), static_cast<int>(column), 1);
  }
  for (int k = 0; k < size; ++k) pattern.emplace_back(k, k, 1);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(pattern.begin(), pattern.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(matrix.selfadjointView<Eigen::Lower>(), order);
  for (Eigen::Index k = 0; k < size; ++k) {
    step_of_[static_cast<std::size_t>(order.indices()[k])] = static_cast<std::size_t>(k);
  }
}

/// Finds the rows of each column of L: its rows in the matrix, and those that it inherits from each
/// earlier column whose first row it is.
template <int kSize>
void BlockCholesky<kSize>::findFill(const std::vector<Entry>& entries) {
  const std::size_t size = step_of_.size();
  std::vector<std::vector<std::size_t>> rows(size);
  for (const auto& [row, column] : entries) {
    const auto [first, last] = std::minmax(step_of_[row], step_of_[column]);
    rows[first].push_back(last);
  }
  for (std::size_t column = 0; column < size; ++column) {
    std::vector<std::size_t>& here = rows[column];
    std::ranges::sort(here);
    here.erase(std::unique(here.begin(), here.end()), here.end());
    begin_[column] = rows_.size();
    rows_.insert(rows_.end(), here.begin(), here.end());
    if (here.size() > 1) {
      std::vector<std::size_t>& parent = rows[here.front()];
      parent.insert(parent.end(), here.begin() + 1, here.end());
    }
    here = {};
  }
  begin_[size] = rows_.size();
}

template <int kSize>
std::size_t BlockCholesky<kSize>::placeOf(std::size_t row, std::size_t column) const {
  const auto begin = rows_.begin() + static_cast<std::ptrdiff_t>(begin_[column]);
  const auto end = rows_.begin() + static_cast<std::ptrdiff_t>(begin_[column + 1]);
  return static_cast<std::size_t>(std::lower_bound(begin, end, row) - rows_.begin());
}

template <int kSize>
void BlockCholesky<kSize>::setZero() {
  std::ranges::fill(diagonal_, Block::Zero());
  std::ranges::fill(blocks_, Block::Zero());
}

template <int kSize>
void BlockCholesky<kSize>::add(std::size_t k, const Block& block) {
  const auto& [place, transposed] = places_[k];
  if (transposed) {
    blocks_[place] += block.transpose();
  } else {
    blocks_[place] += block;
  }
}

template <int kSize>
bool BlockCholesky<kSize>::factorise() {
  log_determinant_ = 0;
  for (std::size_t step = 0; step < diagonal_.size(); ++step) {
    if (!invertPositive(diagonal_[step], log_determinant_)) return false;
    const auto first = blocks_.begin() + static_cast<std::ptrdiff_t>(begin_[step]);
    const auto last = blocks_.begin() + static_cast<std::ptrdiff_t>(begin_[step + 1]);
    column_.assign(first, last);
    for (std::size_t k = 0; k < column_.size(); ++k) {
      blocks_[begin_[step] + k].noalias() = column_[k] * diagonal_[step];
    }
    spread(step);
  }
  return true;
}

/// Subtracts L D L' of the column from the columns of its rows.
template <int kSize>
void BlockCholesky<kSize>::spread(std::size_t step) {
  const std::size_t end = begin_[step + 1];
  for (std::size_t k = begin_[step]; k < end; ++k) {
    const Block& other = column_[k - begin_[step]];
    diagonal_[rows_[k]].noalias() -= blocks_[k] * other.transpose();
    std::size_t into = begin_[rows_[k]];
    for (std::size_t below = k + 1; below < end; ++below, ++into) {
      while (rows_[into] != rows_[below]) ++into;
      blocks_[into].noalias() -= blocks_[below] * other.transpose();
    }
  }
}

template <int kSize>
template <int kColumns>
void BlockCholesky<kSize>::solve(std::vector<Eigen::Matrix<double, kSize, kColumns>>& x) const {
  std::vector<Eigen::Matrix<double, kSize, kColumns>> y(x.size());
  for (std::size_t row = 0; row < x.size(); ++row) y[step_of_[row]] = x[row];
  for (std::size_t column = 0; column < y.size(); ++column) {
    for (std::size_t k = begin_[column]; k < begin_[column + 1]; ++k) {
      y[rows_[k]].noalias() -= blocks_[k] * y[column];
    }
  }
  for (std::size_t column = y.size(); column-- > 0;) {
    y[column] = (diagonal_[column] * y[column]).eval();
    for (std::size_t k = begin_[column]; k < begin_[column + 1]; ++k) {
      y[column].noalias() -= blocks_[k].transpose() * y[rows_[k]];
    }
  }
  for (std::size_t row = 0; row < x.size(); ++row) x[row] = y[step_of_[row]];
}

template class BlockCholesky<3>;
template class BlockCholesky<6>;
template void BlockCholesky<3>::solve(std::vector<Eigen::Matrix<double, 3, 1>>&) const;
template void BlockCholesky<3>::solve(std::vector<Eigen::Matrix<double, 3, 4>>&) const;
template void BlockCholesky<6>::solve(std::vector<Eigen::Matrix<double, 6, 1>>&) const;
template void BlockCholesky<6>::solve(std::vector<Eigen::Matrix<double, 6, 4>>&) const;

}  // namespace tolman::experience_map
