// SPDX-License-Identifier: BSD-3-Clause
// Ring and torus together: averaging and familiarity.
#include "spatial_cells.hpp"

#include <catch2/catch.hpp>
#include <numbers>

using namespace tolman;
using namespace tolman::paper_attractor;

namespace {

SpatialCells cellsWith(const DecisionSettings& settings) {
  return {HeadDirectionRing({.energy = 100, .initial_calibration = 0}),
          GridTorus({.period = 15, .energy = 1, .initial_calibration = 0}, 10), settings};
}

void see(SpatialCells& cells, const CellPose& pose) {
  cells.inject(pose, 0.4);
  cells.settle();
}

}  // namespace

TEST_CASE("contradicting views average, as printed") {
  // Three views of different places, 3 cells apart: shares .18 .37 .57.
  SpatialCells cells = cellsWith({});
  for (const Phase<2>& place : {Phase<2>(2, 2), Phase<2>(5, 2), Phase<2>(2, 5)}) {
    see(cells, {0.0, place});
  }
  CHECK(cells.calibrationShare() == Approx(0.575).margin(0.002));
}

TEST_CASE("familiar needs heading and position") {
  // Share after three views: 0.575, so the estimate is 0.425 of the disagreement away.
  const auto after3 = [](const CellPose& place) {
    SpatialCells cells = cellsWith({0.2, 1.0});
    for (int i = 0; i < 3; ++i) see(cells, place);
    return cells.familiar();
  };
  CHECK(after3({0.0, {2.3, 0}}));                           // 0.98 of 1 cell
  CHECK_FALSE(after3({0.0, {2.4, 0}}));                     // 1.02
  CHECK(after3({0.46, {0, 0}}));                            // 0.196 of 0.2 rad
  CHECK_FALSE(after3({0.48, {0, 0}}));                      // 0.204
  CHECK(after3({2 * std::numbers::pi - 0.46, {12.8, 0}}));  // -0.46 rad, -2.2 cells
}

TEST_CASE("adopting makes the familiar place the integrators' place") {
  SpatialCells cells = cellsWith({});
  for (int i = 0; i < 4; ++i) see(cells, {0.3, {1, 2}});
  const CellPose estimate = cells.estimate();
  cells.adoptEstimate();
  CHECK(cells.ring().integratedHeading() == estimate.heading);
  CHECK((cells.torus().integrator().mean == estimate.position).all());
  CHECK(estimate.position.y() == Approx(2 * 0.795).margin(0.01));
}

TEST_CASE("a lost odometry gives the views more weight") {
  // w_inte = 0.5, w_cali = 0.4: (3) 0.42 and 0.3, share 0.4167 instead of 0.179.
  SpatialCells cells = cellsWith({});
  cells.inject({0, {1, 0}}, 0.4);
  cells.weakenIntegrators(0.5);
  cells.settle();
  CHECK(cells.calibrationShare() == Approx(0.4167).margin(0.001));
}

TEST_CASE("a pose is displaced in its own frame") {
  const SpatialCells cells = cellsWith({});
  const CellPose pose = cells.displaced({std::numbers::pi / 2, {14, 14.5}}, {10, -20, -2});
  CHECK(pose.position.x() == Approx(1));  // 20 m to the right of who looks along y: +2 cells
  CHECK(pose.position.y() == Approx(0.5));
  CHECK(pose.heading == Approx(2.5 * std::numbers::pi - 2));
}
