// SPDX-License-Identifier: BSD-3-Clause
// Cyclists over time: along the edge of the road, at constant speeds.
#include "cyclists.hpp"

#include <catch2/catch.hpp>

#include "drawn_route.hpp"
#include "people.hpp"
#include "place_of.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

const CameraRoute kRoute = town::test::drawnRoute(LanePath(0).ahead(500));

}  // namespace

TEST_CASE("cyclists ride at the right edge in either direction") {
  const StreetPlan plan = StreetPlan::grow(kRoute, 1.65).value();
  const Cyclists cyclists(kRoute, plan, 20, 3);
  REQUIRE(cyclists.size() == 10);
  int coming = 0;
  for (std::size_t i = 0; i < cyclists.size(); ++i) {
    for (double t = 0; t < 100; t += 7.3) {
      const auto [now, phase] = cyclists.at(i, t);
      const auto [soon, next_phase] = cyclists.at(i, t + 0.1);
      const Eigen::Vector2d step =
          tolman::town::test::placeOf(soon) - tolman::town::test::placeOf(now);
      if (step.norm() > 10) continue;  // from one end of the lane to the other
      CAPTURE(i, t);
      CHECK(step.norm() > 0.1 * 3.5 - 1e-3);
      CHECK(step.norm() < 0.1 * 6 + 1e-3);
      const bool comes = step.y() < 0;
      coming += comes;
      const double over = static_cast<double>(now.position.x) + StreetPlan::kLaneOffset;
      CHECK(over == Approx(comes ? -Cyclists::kOver : Cyclists::kOver).margin(1e-4));
      CHECK(static_cast<double>(now.sine) == Approx(comes ? -1 : 1));
      CHECK(phase >= 0);
      CHECK(phase < kPedalPhases);
      CHECK(static_cast<double>(now.position.z) ==
            Approx(plan.height(tolman::town::test::placeOf(now).x(),
                               tolman::town::test::placeOf(now).y()))
                .margin(1e-4));
    }
  }
  CHECK(coming > 30);
  CHECK(coming < 110);
}

TEST_CASE("a seed makes the cyclists, and no density none") {
  const StreetPlan plan = StreetPlan::grow(kRoute, 1.65).value();
  const Cyclists a(kRoute, plan, 10, 3);
  const Cyclists b(kRoute, plan, 10, 3);
  const Cyclists c(kRoute, plan, 10, 4);
  CHECK(tolman::town::test::placeOf(a.at(2, 11).placement) ==
        tolman::town::test::placeOf(b.at(2, 11).placement));
  CHECK(tolman::town::test::placeOf(a.at(2, 11).placement) !=
        tolman::town::test::placeOf(c.at(2, 11).placement));
  CHECK(Cyclists(kRoute, plan, 0, 3).size() == 0);
}
