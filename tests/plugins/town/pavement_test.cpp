// SPDX-License-Identifier: BSD-3-Clause
// Paths of people: beside every road, never on a road, and round parked cars.
#include "pavement.hpp"

#include <catch2/catch.hpp>

#include "drawn_route.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

StreetPlan planOf(const CameraRoute& route) { return StreetPlan::grow(route, 1.65).value(); }

StreetPlan straight() { return planOf(town::test::drawnRoute(LanePath(0).ahead(150))); }

}  // namespace

TEST_CASE("a straight street has a pavement on each side") {
  const std::vector<PavementRun> runs = pavementRuns(straight(), {});
  REQUIRE(runs.size() == 2);
  CHECK_FALSE(runs[0].is_left);
  CHECK(runs[1].is_left);
  for (const PavementRun& run : runs) {
    CHECK(run.length() > 240);  // 150 m, and 50 m beyond either end
    // The centreline is 1.7 m left of the route along Y.
    const double sign = run.is_left ? -1 : 1;
    for (const double s : {0.0, 77.5, run.length()}) {
      const double over = sign * (run.at(s).position.x() + StreetPlan::kLaneOffset);
      CHECK(over > StreetPlan::kRoadHalfWidth + 0.5);
      CHECK(over < StreetPlan::kRoadHalfWidth + StreetPlan::kPavementWidth);
      CHECK(run.at(s).along.y() == Approx(1));
    }
  }
}

TEST_CASE("people go round a parked car") {
  // A car is 1.72 m wide and stands 0.95 m from the kerb.
  const Eigen::Vector2d car(StreetPlan::kRoadHalfWidth + 0.95 - StreetPlan::kLaneOffset, 60);
  const std::vector<PavementRun> runs = pavementRuns(straight(), {car});
  double nearest = 1e9;
  for (double s = 0; s < runs[0].length(); s += 0.1) {
    const Eigen::Vector2d p = runs[0].at(s).position;
    if (std::abs(p.y() - 60) < 2.1) nearest = std::min(nearest, p.x() - car.x());
  }
  CHECK(nearest > 0.86 + 0.15);
  const std::vector<PavementRun> free = pavementRuns(straight(), {});
  CHECK(free[0].at(110).position.x() < runs[0].at(110).position.x());
  CHECK(free[1].at(110).position == runs[1].at(110).position);
}

TEST_CASE("pavements end at side streets") {
  for (const char* name : {"block", "district"}) {
    const StreetPlan plan = planOf(town::test::builtIn(name));
    const std::vector<PavementRun> runs = pavementRuns(plan, {});
    CHECK(runs.size() >= 2);
    for (const PavementRun& run : runs) {
      CHECK(run.length() > 3);
      for (double s = 0; s < run.length(); s += 0.5) {
        const Eigen::Vector2d p = run.at(s).position;
        REQUIRE(plan.distance(p.x(), p.y()) > StreetPlan::kRoadHalfWidth + 0.3);
      }
    }
  }
}
