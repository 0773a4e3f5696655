// SPDX-License-Identifier: BSD-3-Clause
// The rate maps of single units on a random walk in a box are hexagonal, as those of the rat's grid
// cells (Hafting et al. 2005) and of figure 4 of Guanella et al.
#include <catch2/catch.hpp>

#include "attractor_sheet.hpp"
#include "evaluation/firing_rate.hpp"
#include "support/gridness_oracle.hpp"

using namespace tolman;
using namespace tolman::can_sheet;
using namespace tolman::test;

TEST_CASE("units are hexagonal in a box, by two implementations of gridness") {
  constexpr double kPeriod = 0.4;  // m
  constexpr double kSide = 1.5;    // m
  constexpr int kBins = 40;
  AttractorSheet sheet({.units = 20});
  BoxWalk walk(kSide, 0.02, 12);
  const std::vector<std::size_t> units = {0, 57, 210, 333};
  std::vector<BoxMap> maps(units.size(), BoxMap(kSide, kBins));
  double heading = 0;
  for (int i = 0; i < 40000; ++i) {
    const PlanarPose moved = compose({0, 0, heading}, walk.next());
    heading = moved.theta;
    sheet.step(toPhase(Eigen::Vector2d(moved.x, moved.y) / kPeriod));
    for (std::size_t k = 0; k < units.size(); ++k) {
      maps[k].add(walk.pose(), static_cast<double>(sheet.activity()[units[k]]));
    }
  }
  for (const BoxMap& map : maps) {
    const Eigen::MatrixXd rates = map.rates();
    const OracleScores oracle = oracleScores(rates, kPeriod / kSide * kBins);
    CHECK(oracle.hexagonal > 0.8);
    CHECK(oracle.square < 0.3);
    evaluation::RateMap own;
    own.bin = kSide / kBins;
    own.rate = rates;
    own.visits = Eigen::MatrixXd::Ones(kBins, kBins);
    const auto scores = evaluation::gridScores(own);
    REQUIRE(scores.has_value());
    CHECK(scores->sargolini > 0.8);
    CHECK(scores->spacing == Approx(kPeriod).epsilon(0.1));
  }
}
