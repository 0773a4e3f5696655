// SPDX-License-Identifier: BSD-3-Clause
// Built-in routes as flights.
#include "flown_route.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "drawn_route.hpp"
#include "support/context.hpp"
#include "town_source.hpp"

using namespace tolman;
using namespace tolman::town;

TEST_CASE("a flight follows the streets above them, and passes differ in attitude, not in height") {
  const CameraRoute driven = town::test::builtIn("eights");
  const CameraRoute route = flown(driven);
  REQUIRE(route.T_town_camera.size() == driven.T_town_camera.size());
  CHECK(route.T_town_camera[0].isApprox(driven.T_town_camera[0], 1e-9));
  double highest = 0;
  double tilt = 0;
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
    const Eigen::Isometry3d& T = route.T_town_camera[i];
    const Eigen::Vector3d apart = T.translation() - driven.T_town_camera[i].translation();
    REQUIRE(apart.head<2>().norm() < 1e-9);
    REQUIRE(T.translation().z() > -1e-9);
    highest = std::max(highest, T.translation().z());
    tilt = std::max(tilt, std::acos(std::clamp(-T.linear()(2, 1), -1.0, 1.0)));
  }
  CHECK(highest > 2.5);
  CHECK(highest < 4 + 1e-9);
  CHECK(tilt * 180 / std::numbers::pi > 8);
  CHECK(tilt * 180 / std::numbers::pi < 12);
}

TEST_CASE("the streets below a flight are level and lead the same way") {
  const CameraRoute route = flown(town::test::builtIn("block"));
  const CameraRoute track = groundTrack(route);
  for (std::size_t i = 0; i < track.T_town_camera.size(); ++i) {
    const Eigen::Isometry3d& T = track.T_town_camera[i];
    REQUIRE(std::abs(T.translation().z()) < 1e-9);
    REQUIRE(std::abs(T.linear()(2, 2)) < 1e-9);
    const Eigen::Vector2d ahead = route.T_town_camera[i].linear().col(2).head<2>();
    REQUIRE(T.linear().col(2).head<2>().dot(ahead.normalized()) > 0.9999);
  }
}

TEST_CASE("a building is not flown through") {
  for (const std::string inside : {"hall", "car_park"}) {
    tolman::test::TestContext context({{"route", inside}, {"flight", true}});
    TownSource source;
    const Status status = source.configure(context);
    CHECK(status.message() ==
          "flight: the route " + inside + " is inside a building; use another, or flight: false");
  }
}
