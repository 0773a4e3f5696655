// SPDX-License-Identifier: BSD-3-Clause
// Routes that cross themselves at different heights, before and after they are levelled.
#include "level_route.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "drawn_route.hpp"
#include "street_plan.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::town;
using namespace tolman::town::test;

namespace {

constexpr double kLevelCamera = 1.65;

/// Over its start at a right angle, `apart` m higher.
CameraRoute crossing(double apart) {
  LanePath path(StreetPlan::kLaneOffset);
  path.ahead(100).turnRight(7).ahead(60).turnRight(7).ahead(60).turnRight(7).ahead(120);
  return drawnRoute(path, [=](double s) { return apart * std::clamp((s - 110) / 80, 0.0, 1.0); });
}

}  // namespace

TEST_CASE("a levelled route has streets, and the camera its height above them", "[figures]") {
  for (const double apart : {4.4, 6.2}) {
    const CameraRoute route = crossing(apart);
    REQUIRE_FALSE(StreetPlan::grow(route, kLevelCamera).isOk());
    const CameraRoute level = levelled(route, kLevelCamera);
    const Result<StreetPlan> plan = StreetPlan::grow(level, kLevelCamera);
    INFO(plan.status().message());
    REQUIRE(plan.isOk());
    for (const Eigen::Isometry3d& T : level.T_town_camera) {
      const Eigen::Vector3d place = T.translation();
      CHECK(place.z() - plan.value().height(place.x(), place.y()) ==
            Approx(kLevelCamera).margin(0.25));
    }
  }
}

TEST_CASE("levelling changes heights and pitch only, smoothly") {
  const CameraRoute route = crossing(4.4);
  const CameraRoute level = levelled(route, kLevelCamera);
  REQUIRE(level.T_town_camera.size() == route.T_town_camera.size());
  CHECK(level.stamps_ns == route.stamps_ns);
  double before =
      level.T_town_camera[0].translation().z() - route.T_town_camera[0].translation().z();
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
    const Eigen::Isometry3d& was = route.T_town_camera[i];
    const Eigen::Isometry3d& is = level.T_town_camera[i];
    CHECK(is.translation().head<2>() == was.translation().head<2>());
    const double change = is.translation().z() - was.translation().z();
    CHECK(std::abs(change) < 2.6);
    CHECK(std::abs(change - before) < 0.08);  // m per m
    // The camera's right axis stays, its forward axis rises with the change.
    CHECK((is.linear().col(0) - was.linear().col(0)).norm() < 1e-9);
    if (i > 0) {
      const double rise = std::asin(is.linear()(2, 2)) - std::asin(was.linear()(2, 2));
      CHECK(rise == Approx(std::atan(change - before)).margin(0.01));
    }
    before = change;
  }
}

TEST_CASE("a route that agrees with itself stays where it is") {
  const CameraRoute route = builtIn("block");
  const CameraRoute level = levelled(route, kLevelCamera);
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
    CHECK((level.T_town_camera[i].translation() - route.T_town_camera[i].translation()).norm() <
          0.02);
  }
}

TEST_CASE("KITTI 02, which crosses itself 4.4 m apart, gets streets", "[data]") {
  const auto file = tolman::test::dataOrSkip("kitti_poses/02.txt");
  if (!file) return;
  const CameraRoute route = readRoute(*file, {}).value();
  CHECK_FALSE(StreetPlan::grow(route, kLevelCamera).isOk());
  CHECK(StreetPlan::grow(levelled(route, kLevelCamera), kLevelCamera).isOk());
}
