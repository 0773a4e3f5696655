// SPDX-License-Identifier: BSD-3-Clause
// Rate maps of ideal grid cells: Gaussian fields on a lattice.
#pragma once

#include <cmath>
#include <numbers>

#include "evaluation/firing_rate.hpp"

namespace tolman::test {

/// Rate at `place` of a unit with fields of deviation `width` on all corners i a + j b.
inline double latticeRate(const Eigen::Vector2d& place, const Eigen::Vector2d& a,
                          const Eigen::Vector2d& b, double width) {
  Eigen::Matrix2d basis;
  basis << a, b;
  const Eigen::Vector2d corner = (basis.inverse() * place).array().round();
  double sum = 0;
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      const Eigen::Vector2d away = place - basis * (corner + Eigen::Vector2d(i, j));
      sum += std::exp(-away.squaredNorm() / (2 * width * width));
    }
  }
  return sum;
}

/// `angle` between the axes: 60 degrees make a hexagonal, 90 a square lattice.
inline double latticeRate(const Eigen::Vector2d& place, double spacing, double direction,
                          double angle) {
  const auto axis = [&](double turn) -> Eigen::Vector2d {
    return spacing * Eigen::Vector2d(std::cos(turn), std::sin(turn));
  };
  return latticeRate(place, axis(direction), axis(direction + angle), 0.11 * spacing);
}

/// A map of `side` bins of 1 m, all visited.
template <class Rate>
evaluation::RateMap paintedMap(int side, Rate&& rate) {
  evaluation::RateMap map;
  map.visits = Eigen::MatrixXd::Ones(side, side);
  map.rate.resize(side, side);
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) map.rate(i, j) = rate(Eigen::Vector2d(i + 0.5, j + 0.5));
  }
  return map;
}

}  // namespace tolman::test
