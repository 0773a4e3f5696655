// SPDX-License-Identifier: BSD-3-Clause
// Against closed forms: the Fourier transform of Gaussian fields on a lattice.
#include "report/periodicity.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

using namespace tolman::report;
using tolman::evaluation::RateMap;

namespace {

constexpr int kSide = 60;
constexpr double kBin = 2;  // m
constexpr double kTurn = 2 * std::numbers::pi;

using Rate = std::function<double(const Eigen::Vector2d&)>;  // at a place in m

/// Every bin was visited once, or as `visited` says.
RateMap painted(
    const Rate& rate,
    const std::function<bool(int, int)>& visited = [](int, int) { return true; }) {
  RateMap map;
  map.bin = kBin;
  map.visits = Eigen::MatrixXd::Zero(kSide, kSide);
  map.rate = Eigen::MatrixXd::Constant(kSide, kSide, std::nan(""));
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      if (!visited(i, j)) continue;
      map.visits(i, j) = 1;
      map.rate(i, j) = rate({kBin * (i + 0.5), kBin * (j + 0.5)});
    }
  }
  return map;
}

/// Gaussian fields of deviation `width` on all corners `i a + j b`, one at the middle of the map.
Rate lattice(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double width) {
  return [=](const Eigen::Vector2d& place) {
    double sum = 0;
    for (int i = -12; i <= 12; ++i) {
      for (int j = -12; j <= 12; ++j) {
        const Eigen::Vector2d away =
            place - Eigen::Vector2d::Constant(kBin * kSide / 2) - i * a - j * b;
        sum += std::exp(-away.squaredNorm() / (2 * width * width));
      }
    }
    return sum;
  };
}

Rate squareLattice(double spacing, double direction, double width) {
  const Eigen::Vector2d a = spacing * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  return lattice(a, {-a.y(), a.x()}, width);
}

}  // namespace

TEST_CASE("spacing, direction and depth of a square lattice are found") {
  for (const double direction_deg : {0.0, 20.0, 44.0, 70.0}) {
    const double direction = direction_deg * kTurn / 360;
    for (const double spacing : {15.0, 20.0, 30.0}) {
      const double width = 0.15 * spacing;
      const auto found = squarePeriodicity(painted(squareLattice(spacing, direction, width)));
      REQUIRE(found);
      CHECK(found->spacing == Approx(spacing).epsilon(0.025));
      CHECK(std::remainder(found->direction - direction, kTurn / 4) == Approx(0).margin(0.05));
      // Fields of a Gaussian profile have the transform exp(-(k width)^2 / 2) on the lattice.
      const double k = kTurn / spacing;
      CHECK(found->score == Approx(std::exp(-k * k * width * width / 2)).epsilon(0.08));
    }
  }
}

TEST_CASE("fields in bands, on a hexagonal lattice and everywhere are not square") {
  const double square = squarePeriodicity(painted(squareLattice(20, 0.3, 2)))->score;
  CHECK(square > 0.75);
  const Rate bands = [](const Eigen::Vector2d& p) { return 1 + std::cos(kTurn * p.x() / 20); };
  CHECK(squarePeriodicity(painted(bands))->score < 0.1);
  const Rate hexagonal = lattice({20, 0}, {10, 10 * std::sqrt(3)}, 2);
  CHECK(squarePeriodicity(painted(hexagonal))->score < 0.5 * square);
  const auto everywhere = squarePeriodicity(painted([](const Eigen::Vector2d&) { return 3.0; }));
  CHECK(everywhere->score == Approx(0).margin(1e-4));
}

TEST_CASE("streets are enough: most of the ground need not be visited") {
  const auto street = [](int i, int j) { return i % 12 < 2 || j % 15 < 2 || (i + j) % 30 < 2; };
  const auto found = squarePeriodicity(painted(squareLattice(25, 0.2, 3), street));
  REQUIRE(found);
  CHECK(found->spacing == Approx(25).epsilon(0.05));
  CHECK(found->direction == Approx(0.2).margin(0.07));
}

TEST_CASE("the score knows no unit of rate, not even a vanishing one") {
  const RateMap loud = painted(squareLattice(20, 0.3, 2));
  RateMap faint = loud;
  faint.rate *= 1e-30;
  CHECK(squarePeriodicity(faint)->score == Approx(squarePeriodicity(loud)->score));
}

TEST_CASE("there is no score without a rate, or where one and a half periods had no room") {
  CHECK_FALSE(squarePeriodicity({}));
  CHECK_FALSE(squarePeriodicity(painted([](const Eigen::Vector2d&) { return 0.0; })));
  RateMap narrow = painted(squareLattice(20, 0, 2));
  narrow.rate = narrow.rate.topRows(5).eval();
  narrow.visits = narrow.visits.topRows(5).eval();
  CHECK_FALSE(squarePeriodicity(narrow));
}
