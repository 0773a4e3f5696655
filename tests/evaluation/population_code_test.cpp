// SPDX-License-Identifier: BSD-3-Clause
// Decoding of rings whose state is known.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "evaluation/recorded_cells.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

}  // namespace

TEST_CASE("the population vector of a von Mises ring is its centre, in the unit of the axis") {
  for (const double centre : {0.0, 1.234, 3.1, 6.2}) {
    std::vector<double> rates;
    for (int i = 0; i < 36; ++i) rates.push_back(std::exp(2.4 * std::cos(centre - i * kTurn / 36)));
    const ArrayAxis radians{"heading", "rad", 0, kTurn / 36, kTurn, {}};
    CHECK(populationVector(rates, radians) == Approx(centre).margin(1e-9));
    const ArrayAxis degrees{"heading", "deg", 90, 10, 360, {}};  // unit 0 stands for 90 degrees
    CHECK(std::remainder(*populationVector(rates, degrees) - centre * 360 / kTurn - 90, 360) ==
          Approx(0).margin(1e-7));
  }
}

TEST_CASE("a ring without activity, or with equal activity everywhere, has no direction") {
  const ArrayAxis axis{"heading", "rad", 0, kTurn / 12, kTurn, {}};
  CHECK_FALSE(populationVector(std::vector<double>(12, 0), axis));
  CHECK_FALSE(populationVector(std::vector<double>(12, 3.7), axis));
}
