// SPDX-License-Identifier: BSD-3-Clause
// Single cells against closed forms.
#include "activity.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman;
using namespace tolman::paper_attractor;

namespace {

PeriodicBump<2> bumpAt(double x, double y, double precision) {
  PeriodicBump<2> bump;
  bump.mean = {x, y};
  bump.precision = precision;
  return bump;
}

}  // namespace

TEST_CASE("the cell at the bump fires most, its neighbours by equation (7), round the seam too") {
  const std::vector<float> rates = torusActivity(bumpAt(0, 14, 0.5), 15, 15);
  REQUIRE(rates.size() == 225);
  CHECK(rates[14 * 15] == Approx(1));
  CHECK(rates[14 * 15 + 1] == Approx(std::exp(-0.25)));
  CHECK(rates[14 * 15 + 14] == Approx(std::exp(-0.25)));
  CHECK(rates[0] == Approx(std::exp(-0.25)));
  CHECK(rates[14] == Approx(std::exp(-0.5)));
}

TEST_CASE("a cell's own field widens its rate as variances add") {
  const double width = 0.1;  // 1.5 cells of 15
  const std::vector<float> rates = torusActivity(bumpAt(3, 3, 1), 15, 15, width);
  const double variance = 1 + 1.5 * 1.5;
  CHECK(rates[3 * 15 + 3] == Approx(1));
  CHECK(rates[3 * 15 + 5] == Approx(std::exp(-0.5 * 4 / variance)));
  // Against the mean of the cell's field under the bump, summed.
  double expected = 0;
  double best = 0;
  for (double x = -8; x <= 8; x += 0.01) {
    const double bump = std::exp(-0.5 * x * x);
    expected += bump * std::exp(-0.5 * (x - 2) * (x - 2) / (1.5 * 1.5));
    best += bump * std::exp(-0.5 * x * x / (1.5 * 1.5));
  }
  CHECK(rates[3 * 15 + 5] == Approx(expected / best).epsilon(1e-3));
}

TEST_CASE("a head direction cell fires at its own heading alone, its neighbours alike") {
  PeriodicBump<1> north;
  north.mean = Phase<1>(0);
  north.precision = 100;
  const std::vector<float> rates = ringActivity(north, 2 * M_PI, 36);
  CHECK(rates[0] == Approx(1));
  CHECK(rates[18] < 1e-6F);
  CHECK(rates[9] < 1e-6F);
  CHECK(rates[1] == Approx(rates[35]));
}
