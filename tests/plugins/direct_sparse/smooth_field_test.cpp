// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <cmath>

#include "disparity_field.hpp"

using tolman::direct_sparse::SmoothField;

namespace {

constexpr int kFieldWidth = 200;
constexpr int kFieldHeight = 80;

SmoothField fieldOf(std::initializer_list<double> coefficients) {
  SmoothField field;
  int k = 0;
  for (const double value : coefficients) field.coefficients[k++] = value;
  return field;
}

}  // namespace

TEST_CASE("terms of a smooth field are orthogonal over the image") {
  Eigen::Matrix<double, SmoothField::kTerms, SmoothField::kTerms> products;
  products.setZero();
  for (int v = 0; v < kFieldHeight; ++v) {
    for (int u = 0; u < kFieldWidth; ++u) {
      const auto terms = SmoothField::termsAt(u, v, kFieldWidth, kFieldHeight);
      products += terms * terms.transpose() / (kFieldWidth * kFieldHeight);
    }
  }
  for (int i = 0; i < SmoothField::kTerms; ++i) {
    for (int j = 0; j < i; ++j) CHECK(std::abs(products(i, j)) < 1e-3);
  }
  CHECK(products(0, 0) == Approx(1));
}

TEST_CASE("a field has its value at the borders of the image") {
  // 2 + 3 y, and 4 x: the constant, the second and the fifth term.
  const SmoothField field = fieldOf({2, 3, 0, 0, 4});
  CHECK(field.at(-0.5, -0.5, kFieldWidth, kFieldHeight) == Approx(2 - 3 - 4));
  CHECK(field.at(kFieldWidth - 0.5, kFieldHeight - 0.5, kFieldWidth, kFieldHeight) ==
        Approx(2 + 3 + 4));
  CHECK(field.at(kFieldWidth / 2.0 - 0.5, kFieldHeight - 0.5, kFieldWidth, kFieldHeight) ==
        Approx(2 + 3));
}

TEST_CASE("degrees of the terms are those of their polynomials") {
  // The (n + 1)-th differences of a polynomial of degree n are zero.
  for (int k = 0; k < SmoothField::kTerms; ++k) {
    const int degree = SmoothField::kDegrees[static_cast<std::size_t>(k)];
    double difference = 0;
    double binomial = 1;
    for (int i = 0; i <= degree + 1; ++i) {
      const double sign = i % 2 == 0 ? 1 : -1;
      difference +=
          sign * binomial * SmoothField::termsAt(9.0 * i, 7.0 * i, kFieldWidth, kFieldHeight)[k];
      binomial *= static_cast<double>(degree + 1 - i) / (i + 1);
    }
    CHECK(std::abs(difference) < 1e-9);
  }
}
