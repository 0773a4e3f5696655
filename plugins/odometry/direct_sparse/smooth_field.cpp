// SPDX-License-Identifier: BSD-3-Clause
#include "smooth_field.hpp"

#include <cmath>

namespace tolman::direct_sparse {
namespace {

constexpr int kDegree = SmoothField::kDegree;

/// P_0 to P_3 at x.
std::array<double, kDegree + 1> legendre(double x) {
  return {1, x, 0.5 * (3 * x * x - 1), 0.5 * (5 * x * x * x - 3 * x)};
}

/// Calls `use(term, i, j)` for each term P_i(x) P_j(y).
template <class Use>
void forEachTerm(Use use) {
  int term = 0;
  for (int i = 0; i <= kDegree; ++i) {
    for (int j = 0; i + j <= kDegree; ++j) use(term++, i, j);
  }
}

}  // namespace

SmoothField::Terms SmoothField::termsAt(double u, double v, int width, int height) {
  const auto across = legendre((2 * u + 1) / width - 1);
  const auto down = legendre((2 * v + 1) / height - 1);
  Terms terms;
  forEachTerm([&](int term, int i, int j) {
    terms[term] = across[static_cast<std::size_t>(i)] * down[static_cast<std::size_t>(j)];
  });
  return terms;
}

double SmoothField::rms() const { return std::hypot(coefficients[0], rmsWithoutOffset()); }

double SmoothField::rmsWithoutOffset() const {
  // Legendre polynomials are orthogonal; the mean of P_i^2 over [-1, 1] is 1 / (2 i + 1).
  double square = 0;
  forEachTerm([&](int term, int i, int j) {
    if (term == 0) return;
    square += coefficients[term] * coefficients[term] / ((2 * i + 1) * (2 * j + 1));
  });
  return std::sqrt(square);
}

}  // namespace tolman::direct_sparse
