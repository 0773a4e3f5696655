// SPDX-License-Identifier: BSD-3-Clause
// Grid scores of ideal lattices, whose symmetry is known.
#include <catch2/catch.hpp>

#include "evaluation/firing_rate.hpp"
#include "evaluation/lattice_maps.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

constexpr double kHexagonal = std::numbers::pi / 3;
constexpr double kSquare = std::numbers::pi / 2;
constexpr int kSide = 40;

RateMap lattice(double spacing, double direction, double angle) {
  return test::paintedMap(kSide, [&](const Eigen::Vector2d& place) {
    return test::latticeRate(place, spacing, direction, angle);
  });
}

RateMap noise(std::uint64_t seed) {
  RandomStream random(seed);
  return test::paintedMap(kSide, [&](const Eigen::Vector2d&) { return random.uniform(); });
}

/// Correlation of a map with itself at one displacement, as Pearson's formula is printed.
double correlationAt(const RateMap& map, int di, int dj) {
  std::vector<double> a;
  std::vector<double> b;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      if (i + di < 0 || i + di >= kSide || j + dj < 0 || j + dj >= kSide) continue;
      if (!(map.visits(i, j) > 0) || !(map.visits(i + di, j + dj) > 0)) continue;
      a.push_back(map.rate(i, j));
      b.push_back(map.rate(i + di, j + dj));
    }
  }
  const Eigen::Map<Eigen::ArrayXd> x(a.data(), static_cast<Eigen::Index>(a.size()));
  const Eigen::Map<Eigen::ArrayXd> y(b.data(), static_cast<Eigen::Index>(b.size()));
  const Eigen::ArrayXd u = x - x.mean();
  const Eigen::ArrayXd v = y - y.mean();
  return (u * v).sum() / std::sqrt(u.square().sum() * v.square().sum());
}

}  // namespace

TEST_CASE("the autocorrelogram is Pearson's correlation at each displacement") {
  RateMap map = noise(3);
  for (int i = 0; i < kSide; ++i) map.visits(i, (7 * i) % kSide) = 0;  // places nobody visited
  const int reach = 9;
  const Eigen::MatrixXd r = autocorrelogram(map, reach);
  for (const auto& [di, dj] : {std::pair(0, 0), {3, 2}, {3, -2}, {-5, 9}, {0, 4}, {9, 0}}) {
    CHECK(r(reach + di, reach + dj) == Approx(correlationAt(map, di, dj)).margin(1e-9));
  }
}

TEST_CASE("displacements with fewer than 20 common bins are not known") {
  RateMap map = noise(4);
  map.visits.setZero();
  map.visits.row(5).setOnes();  // a street of 40 bins
  const Eigen::MatrixXd r = autocorrelogram(map, 25);
  CHECK(r(25, 25 + 20) == r(25, 25 + 20));
  CHECK(std::isnan(r(25, 25 + 21)));
  CHECK(std::isnan(r(26, 25)));
}

TEST_CASE("a hexagonal lattice scores as hexagonal, however turned, and not as square") {
  for (const double direction : {0.0, 0.2, 0.9}) {
    const auto scores = gridScores(lattice(12, direction, kHexagonal));
    REQUIRE(scores);
    CHECK(scores->sargolini > 1);
    CHECK(scores->langston >= scores->sargolini);
    CHECK(scores->square < 0.2);
    CHECK(scores->spacing == Approx(12).margin(0.5));
  }
}

TEST_CASE("a square lattice scores as square, however turned, and not as hexagonal") {
  for (const double direction : {0.0, 0.3, 0.7}) {
    const auto scores = gridScores(lattice(11, direction, kSquare));
    REQUIRE(scores);
    CHECK(scores->square > 1);
    CHECK(scores->sargolini < 0.2);
    CHECK(scores->spacing == Approx(11).margin(0.5));
  }
}

TEST_CASE("noise has scores about zero") {
  double square = 0;
  double sargolini = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto scores = gridScores(noise(seed));
    REQUIRE(scores);
    square += scores->square / 20;
    sargolini += scores->sargolini / 20;
  }
  CHECK(std::abs(square) < 0.2);
  CHECK(std::abs(sargolini) < 0.3);  // the larger of two correlations is taken off
}

TEST_CASE("no score for a unit that fires alike everywhere, and for a narrow path") {
  CHECK_FALSE(gridScores(test::paintedMap(kSide, [](const auto&) { return 2.0; })));
  CHECK_FALSE(gridScores(test::paintedMap(kSide, [](const auto&) { return 0.0; })));
  RateMap street = lattice(12, 0, kSquare);
  street.rate = street.rate.topRows(4).eval();
  street.visits = street.visits.topRows(4).eval();
  CHECK_FALSE(gridScores(street));
  CHECK_FALSE(gridScores({}));
}
