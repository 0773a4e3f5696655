// SPDX-License-Identifier: BSD-3-Clause
// Inverse, factorisation and determinant against Eigen's dense ones.
#include "block_cholesky.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <tolman/context.hpp>

#include "pose_link.hpp"

namespace tolman::experience_map {
namespace {

/// A matrix R' R of blocks that has the pattern of the entries, and itself dense.
template <int kSize>
struct Sparse {
  using Block = Eigen::Matrix<double, kSize, kSize>;

  Sparse(std::uint64_t seed, std::size_t count, std::size_t links) : random(seed), rows(count) {
    const auto size = static_cast<Eigen::Index>(kSize * rows);
    dense = Eigen::MatrixXd::Identity(size, size);
    for (std::size_t k = 1; k < rows; ++k) add(k, k - 1);
    for (std::size_t k = 0; k < links; ++k) {
      const std::size_t a = random.below(rows);
      const std::size_t b = random.below(rows);
      if (a != b) add(std::max(a, b), std::min(a, b));
    }
  }

  /// J' J of a row of two random blocks.
  void add(std::size_t row, std::size_t column) {
    entries.emplace_back(row, column);
    Block by_row;
    Block by_column;
    for (double& value : by_row.reshaped()) value = random.normal();
    for (double& value : by_column.reshaped()) value = random.normal();
    at(row, row) += by_row.transpose() * by_row;
    at(column, column) += by_column.transpose() * by_column;
    const Block across = by_row.transpose() * by_column;
    blocks.push_back(across);
    at(row, column) += across;
    at(column, row) += across.transpose();
  }
  auto at(std::size_t row, std::size_t column) {
    return dense.template block<kSize, kSize>(static_cast<Eigen::Index>(kSize * row),
                                              static_cast<Eigen::Index>(kSize * column));
  }
  void fill(BlockCholesky<kSize>& factors) {
    factors.setZero();
    for (std::size_t k = 0; k < rows; ++k) factors.diagonal(k) = at(k, k);
    for (std::size_t k = 0; k < entries.size(); ++k) factors.add(k, blocks[k]);
  }

  RandomStream random;
  std::size_t rows;
  Eigen::MatrixXd dense;
  std::vector<typename BlockCholesky<kSize>::Entry> entries;
  std::vector<Block> blocks;
};

template <int kSize, int kColumns>
void checkSolution(Sparse<kSize>& matrix, const BlockCholesky<kSize>& factors) {
  Eigen::MatrixXd right(matrix.dense.rows(), kColumns);
  for (double& value : right.reshaped()) value = matrix.random.normal();
  std::vector<Eigen::Matrix<double, kSize, kColumns>> x(matrix.rows);
  for (std::size_t k = 0; k < matrix.rows; ++k) {
    x[k] = right.template middleRows<kSize>(static_cast<Eigen::Index>(kSize * k));
  }
  factors.solve(x);
  const Eigen::MatrixXd expected = matrix.dense.ldlt().solve(right);
  for (std::size_t k = 0; k < matrix.rows; ++k) {
    const auto rows = expected.template middleRows<kSize>(static_cast<Eigen::Index>(kSize * k));
    CHECK((x[k] - rows).norm() < 1e-8 * (1 + rows.norm()));
  }
}

template <class G>
void checkRandomMatrices() {
  constexpr int kSize = G::kSize;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Sparse<kSize> matrix(seed, 5 * seed, 4 * seed);
    BlockCholesky<kSize> factors(matrix.rows, matrix.entries);
    for (int round = 0; round < 2; ++round) {  // the order serves again
      matrix.fill(factors);
      REQUIRE(factors.factorise());
      checkSolution<kSize, 1>(matrix, factors);
      checkSolution<kSize, 4>(matrix, factors);
      CHECK(factors.logDeterminant() ==
            Approx(matrix.dense.ldlt().vectorD().array().log().sum()).epsilon(1e-10));
      matrix.at(1, 1) += 3 * MatrixOf<G>::Identity();
    }
  }
}

}  // namespace

TEMPLATE_TEST_CASE("sparse blocks are solved as the dense matrix is", "", Plane, Space) {
  checkRandomMatrices<TestType>();
}

TEST_CASE("a single block needs no entries") {
  BlockCholesky<3> factors(1, {});
  factors.setZero();
  factors.diagonal(0) = Eigen::Vector3d(1, 2, 4).asDiagonal();
  REQUIRE(factors.factorise());
  CHECK(factors.logDeterminant() == Approx(std::log(8)));
  std::vector<Eigen::Vector3d> x = {{1, 2, 4}};
  factors.solve(x);
  CHECK((x[0] - Eigen::Vector3d::Ones()).norm() < 1e-14);
}

TEST_CASE("a matrix that is not positive definite is refused") {
  BlockCholesky<3> factors(2, {{1, 0}});
  factors.setZero();
  factors.diagonal(0).setIdentity();
  factors.diagonal(1).setIdentity();
  factors.add(0, Eigen::Matrix3d::Identity());  // singular: the rows are the same
  CHECK_FALSE(factors.factorise());
}

TEST_CASE("the inverse of a positive definite matrix, and the logarithm of its determinant") {
  RandomStream random(4);
  for (int k = 0; k < 50; ++k) {
    Matrix6d root;
    for (double& value : root.reshaped()) value = random.normal();
    Matrix6d matrix = root * root.transpose() + 1e-3 * Matrix6d::Identity();
    matrix.row(2) *= 1e4;  // units may differ widely
    matrix.col(2) *= 1e4;
    const Matrix6d expected = matrix.inverse();
    double log_determinant = 1;
    Matrix6d inverse = matrix;
    REQUIRE(invertPositive(inverse, log_determinant));
    CHECK((inverse * matrix - Matrix6d::Identity()).norm() < 1e-6);
    CHECK((inverse - expected).norm() < 1e-6 * expected.norm());
    CHECK(log_determinant == Approx(1 + std::log(matrix.determinant())));
  }
  Matrix6d indefinite = Matrix6d::Identity();
  indefinite(3, 3) = -1;
  double unused = 0;
  CHECK_FALSE(invertPositive(indefinite, unused));
}

}  // namespace tolman::experience_map
