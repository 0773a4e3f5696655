// SPDX-License-Identifier: BSD-3-Clause
// Equations (2) to (6) against numbers by hand, and the tables of the method notes.
#include "attractor_network.hpp"

#include <catch2/catch.hpp>
#include <numbers>
#include <vector>

#include "grid_torus.hpp"
#include "head_direction_ring.hpp"

using namespace tolman;
using namespace tolman::paper_attractor;

namespace {

AttractorNetwork<1> network(double of_calibration, double of_integrator, double energy = 1) {
  AttractorNetwork<1> result({.period = 15,
                              .energy = energy,
                              .initial_calibration = 0,
                              .inhibition_of_calibration = of_calibration,
                              .inhibition_of_integrator = of_integrator});
  result.restartCalibration();
  return result;
}

/// Shares of the calibration after 1, 2, ... consecutive injections of 0.4 E.
std::vector<double> shares(AttractorNetwork<1> cells, int count) {
  std::vector<double> result;
  for (int n = 0; n < count; ++n) {
    cells.inject(Phase<1>(3), 0.4);
    cells.settle();
    result.push_back(cells.calibrationShare());
  }
  return result;
}

/// Views until a burst of n false injections is forgotten.
int recovery(AttractorNetwork<1> cells, int n) {
  for (int i = 0; i < n; ++i) {
    cells.inject(Phase<1>(3), 0.4);
    cells.settle();
  }
  int views = 0;
  for (; cells.calibrationShare() > 1e-3 && views < 1000; ++views) cells.settle();
  return views;
}

}  // namespace

TEST_CASE("mutual and global inhibition by hand") {
  // E = 100, w_inte = 100, w_cali = 40 after one injection of 0.4 E on the floor of 1e-4 (left out
  // here: it changes the sixth digit).
  // (3) with both 0.2:  w_inte = 100 - 0.2 * 40 = 92,  w_cali = 40 - 0.2 * 100 = 20
  // (2) s = 112:        w_inte = 100 * 92 / 112 = 82.142857,  w_cali = 17.857143
  // (6) the estimate takes over 17.857 % of the way from 1 to 4: 1.535714
  AttractorNetwork<1> cells = network(0.2, 0.2, 100);
  cells.integrate(Phase<1>(1));
  cells.inject(Phase<1>(4), 0.4);
  CHECK(cells.injected().precision == 40);
  CHECK(cells.calibration().mean(0) == Approx(4).epsilon(1e-5));
  cells.settle();
  CHECK(cells.integrator().precision == Approx(82.142857).epsilon(1e-5));
  CHECK(cells.calibration().precision == Approx(17.857143).epsilon(1e-5));
  CHECK(cells.estimated().mean(0) == Approx(1.535714).epsilon(1e-5));
  CHECK(cells.estimated().precision == Approx(100));
  CHECK(cells.disagreement() == Approx(4 - 1.535714).epsilon(1e-5));
}

TEST_CASE("share of the disagreement that is corrected after n injections") {
  const auto check = [](const std::vector<double>& got, const std::vector<double>& expected) {
    const std::vector<std::size_t> n = {1, 2, 3, 4, 5, 6, 8, 10};
    for (std::size_t i = 0; i < n.size(); ++i) {
      CHECK(got[n[i] - 1] == Approx(expected[i]).margin(0.0051));  // printed with two digits
    }
  };
  check(shares(network(0.05, 0), 10), {.26, .46, .60, .71, .79, .85, .92, .96});
  check(shares(network(0.20, 0), 10), {.17, .32, .47, .59, .69, .77, .87, .93});
  check(shares(network(0.20, 0.20), 10), {.18, .37, .57, .79, 1., 1., 1., 1.});
}

TEST_CASE("decay of calibration energy after a run of false views") {
  for (const auto& [n, weak, strong] :
       {std::tuple{1, 7, 1}, std::tuple{2, 17, 3}, std::tuple{3, 31, 5}, std::tuple{4, 50, 8}}) {
    CHECK(recovery(network(0.05, 0), n) == weak);
    CHECK(recovery(network(0.20, 0), n) == strong);
  }
  // Symmetric inhibition has two stable states: beyond a share of one half it never decays.
  CHECK(recovery(network(0.20, 0.20), 1) == 2);
  CHECK(recovery(network(0.20, 0.20), 2) == 4);
  CHECK(recovery(network(0.20, 0.20), 3) == 1000);
}

TEST_CASE("path integration moves both bumps and deforms neither") {
  AttractorNetwork<1> cells = network(0.2, 0.2);
  cells.inject(Phase<1>(4), 0.4);
  cells.settle();
  const auto before = cells;
  cells.integrate(Phase<1>(13.5));  // across the seam
  CHECK(cells.integrator().mean(0) == Approx(13.5));
  CHECK(cells.calibration().mean(0) == Approx(before.calibration().mean(0) + 13.5 - 15));
  CHECK(cells.integrator().precision == before.integrator().precision);
  CHECK(cells.calibration().precision == before.calibration().precision);
  CHECK(cells.disagreement() == Approx(before.disagreement()));
  CHECK(cells.injected().precision == 0);
}

TEST_CASE("the adopted estimate becomes the integrator's mean and ends the calibration") {
  AttractorNetwork<1> cells = network(0.2, 0.2);
  for (int i = 0; i < 3; ++i) {
    cells.inject(Phase<1>(2), 0.4);
    cells.settle();
  }
  const double estimate = cells.estimated().mean(0);
  cells.adoptEstimate();
  CHECK(cells.integrator().mean(0) == estimate);
  CHECK(cells.estimated().mean(0) == estimate);
  CHECK(cells.calibrationShare() < 1e-3);
  CHECK(cells.integrator().precision == 1);
}

TEST_CASE("a square driven on torus and ring returns, also across the seam") {
  const double side = GENERATE(3.0, 40.0, 170.0);  // m; the period is 150 m
  HeadDirectionRing ring({.energy = 100});
  GridTorus torus({.period = 15}, 10);
  for (int edge = 0; edge < 4; ++edge) {
    for (int i = 0; i < 50; ++i) torus.move(side / 50, 0, ring.integratedHeading());
    for (int i = 0; i < 9; ++i) ring.turn(std::numbers::pi / 18);
    if (edge != 1) continue;
    // At the opposite corner.
    CHECK(distance<2>(torus.integrator().mean, wrapped<2>({side / 10, side / 10}, 15), 15) < 1e-9);
  }
  CHECK(distance<2>(torus.integrator().mean, {0, 0}, 15) < 1e-9);
  CHECK(distance<1>(ring.integrator().mean, Phase<1>(0), ring.period()) < 1e-9);
}

TEST_CASE("a step of many periods lands where it should") {
  GridTorus torus({.period = 15}, 10);
  torus.move(1e6 + 37, -1e6 - 21, 0);  // m: 3.7 and -2.1 cells and whole periods of 150 m
  const Phase<2> expected = wrapped<2>(Phase<2>((1e6 + 37) / 10, -(1e6 + 21) / 10), 15);
  CHECK(distance<2>(torus.integrator().mean, expected, 15) < 1e-9);
  CHECK((torus.integrator().mean >= 0).all());
  CHECK((torus.integrator().mean < 15).all());
}
