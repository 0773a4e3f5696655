// SPDX-License-Identifier: BSD-3-Clause
// Ring and torus together: the consistency gate, familiarity, patience.
#include "spatial_cells.hpp"

#include <catch2/catch.hpp>
#include <numbers>

using namespace tolman;
using namespace tolman::bayesian_attractor;

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

TEST_CASE("the gate: contradicting views do not average into a decision") {
  // Three views of different places, 3 cells apart. As printed in the paper they average, the
  // calibration grows past one half and wins: shares .18 .37 .57. Behind the gate each starts anew.
  const CellPose places[] = {{0.0, {2, 2}}, {0.0, {5, 2}}, {0.0, {2, 5}}};
  SpatialCells printed = cellsWith({.consistency_gate = false});
  SpatialCells gated = cellsWith({.consistency_gate = true});
  for (const CellPose& place : places) {
    see(printed, place);
    see(gated, place);
  }
  CHECK(printed.calibrationShare() == Approx(0.575).margin(0.002));
  CHECK(gated.calibrationShare() == Approx(0.179).margin(0.002));
  CHECK_FALSE(gated.familiar());
  CHECK(distance<2>(gated.torus().calibration().mean, {2, 5}, 15) < 0.01);
}

TEST_CASE("the gate lets views within 0.1 rad and 0.3 cell add up") {
  SpatialCells cells = cellsWith({});
  see(cells, {0.05, {1.0, 1.0}});
  see(cells, {0.10, {1.2, 1.0}});
  CHECK(cells.calibrationShare() == Approx(0.370).margin(0.002));
  see(cells, {0.30, {1.1, 1.0}});  // 0.2 rad off
  CHECK(cells.calibrationShare() == Approx(0.179).margin(0.002));
  see(cells, {0.30, {1.1, 1.4}});  // 0.4 cell off
  CHECK(cells.calibrationShare() == Approx(0.179).margin(0.002));
}

TEST_CASE("the gate knows the seams") {
  SpatialCells cells = cellsWith({});
  see(cells, {2 * std::numbers::pi - 0.02, {14.9, 14.95}});
  see(cells, {0.03, {0.1, 0.05}});
  CHECK(cells.calibrationShare() == Approx(0.370).margin(0.002));
}

TEST_CASE("familiar needs share, heading and position") {
  // Share after three views: 0.575, so the estimate is 0.425 of the disagreement away.
  const auto after3 = [](const CellPose& place) {
    SpatialCells cells = cellsWith({});
    for (int i = 0; i < 2; ++i) {
      see(cells, place);
      CHECK_FALSE(cells.familiar());
    }
    see(cells, place);
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

TEST_CASE("an unsupported calibration ends after its patience, even when it had won") {
  SpatialCells cells = cellsWith({.patience = 3});
  for (int i = 0; i < 6; ++i) see(cells, {0, {6, 0}});
  CHECK(cells.calibrationShare() > 0.99);
  for (int view = 0; view < 3; ++view) cells.noteUnsupportedView();
  CHECK(cells.calibrationShare() > 0.99);
  cells.noteUnsupportedView();
  cells.settle();
  CHECK(cells.calibrationShare() < 1e-3);
  CHECK(cells.estimate().position.x() == Approx(0).margin(0.01));
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

TEST_CASE("support counts the views of the present calibration") {
  SpatialCells cells = cellsWith({.patience = 2});
  CHECK(cells.support().views == 0);
  see(cells, {0, {2, 2}});
  see(cells, {0.01, {2.1, 2}});
  CHECK(cells.support().views == 2);
  cells.noteUnsupportedView();
  CHECK(cells.support().unsupported == 1);
  see(cells, {0, {7, 2}});  // contradicts: starts afresh
  CHECK(cells.support().views == 1);
  CHECK(cells.support().unsupported == 0);
  for (int i = 0; i < 3; ++i) cells.noteUnsupportedView();
  CHECK(cells.support().views == 0);  // patience is over
  see(cells, {0, {2, 2}});
  cells.adoptEstimate();
  CHECK(cells.support().views == 0);  // decided
}

TEST_CASE("on the circle a view from behind is no average: the ring keeps its side") {
  SpatialCells gaussian = cellsWith({.consistency_gate = false});
  SpatialCells von_mises = {
      HeadDirectionRing({.energy = 100, .initial_calibration = 0, .on_circle = true}),
      GridTorus({.period = 15, .initial_calibration = 0}, 10),
      {.consistency_gate = false}};
  for (SpatialCells* cells : {&gaussian, &von_mises}) see(*cells, {2.9, {0, 0}});
  CHECK(gaussian.estimate().heading == Approx(0.179 * 2.9).epsilon(0.01));
  // 0.821 at 0 against 0.179 at 2.9 rad: nearly opposite, and outvoted.
  const double expected = std::atan2(0.179 * std::sin(2.9), 0.821 + 0.179 * std::cos(2.9));
  CHECK(von_mises.estimate().heading == Approx(expected).epsilon(0.02));
  CHECK(von_mises.ring().estimated().precision < 70);  // 100 if they agreed
}
