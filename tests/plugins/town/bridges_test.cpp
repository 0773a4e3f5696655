// SPDX-License-Identifier: BSD-3-Clause
// Bridges: which frames are on one, and that road, slab and the street below agree with the poses.
#include "bridges.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "drawn_route.hpp"
#include "level_route.hpp"
#include "probe.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

constexpr double kCamera = 1.65;

/// Over its start at a right angle, `apart` m higher, the slope without kinks.
CameraRoute crossing(double apart) {
  LanePath path(StreetPlan::kLaneOffset);
  path.ahead(100).turnRight(7).ahead(60).turnRight(7).ahead(60).turnRight(7).ahead(120);
  return town::test::drawnRoute(path, [=](double s) {
    const double t = std::clamp((s - 100) / 100, 0.0, 1.0);
    return apart * t * t * (3 - 2 * t);
  });
}

std::size_t raisedFrames(const CameraRoute& route) {
  return static_cast<std::size_t>(std::count(route.raised.begin(), route.raised.end(), true));
}

}  // namespace

TEST_CASE("the upper way is on a bridge near the lower street, and no pose changes") {
  for (const double apart : {3.2, 4.4, 6.2}) {
    const CameraRoute route = crossing(apart);
    const CameraRoute result = bridged(route, kCamera);
    CAPTURE(apart);
    CHECK(raisedFrames(result) > 38);
    CHECK(raisedFrames(result) < 50);
    for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
      REQUIRE(result.T_town_camera[i].isApprox(route.T_town_camera[i], 0));
      if (result.isRaised(i)) CHECK(result.T_town_camera[i].translation().z() > apart - 0.1);
    }
    CHECK(StreetPlan::grow(result, kCamera).isOk());
  }
}

TEST_CASE("small differences, and passes along one street, get no bridge") {
  CHECK(raisedFrames(bridged(crossing(2), kCamera)) == 0);
  CHECK(raisedFrames(bridged(town::test::builtIn("district"), kCamera)) == 0);
  // Once round and over its own start, 4 m higher: the same street.
  LanePath round(StreetPlan::kLaneOffset);
  for (int i = 0; i < 4; ++i) round.ahead(60).turnRight(7);
  round.ahead(60);
  const CameraRoute route = town::test::drawnRoute(round, [](double s) { return s / 60; });
  CHECK(raisedFrames(bridged(route, kCamera)) == 0);
}

TEST_CASE("roads lie camera_height below every camera, on the bridge and under it") {
  const double apart = 5;
  const CameraRoute route = bridged(crossing(apart), kCamera);
  const StreetPlan plan = StreetPlan::grow(route, kCamera).value();
  REQUIRE(plan.decks().size() == 1);
  World world = buildWorld(plan, {});
  addBridges(world, plan);
  const Scene scene(std::move(world));
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
    const Eigen::Vector3d camera = route.T_town_camera[i].translation();
    CAPTURE(i, route.isRaised(i));
    REQUIRE(town::test::distanceTo(scene, camera, -Eigen::Vector3d::UnitZ()) ==
            Approx(kCamera).margin(0.06));
    CHECK(plan.roadHeight(camera.x(), camera.y(), camera.z()) ==
          Approx(camera.z() - kCamera).margin(0.06));
  }
}

TEST_CASE("under the bridge there is room, and its slab overhead") {
  const double apart = 5;
  const CameraRoute route = bridged(crossing(apart), kCamera);
  const StreetPlan plan = StreetPlan::grow(route, kCamera).value();
  World world = buildWorld(plan, {});
  addBridges(world, plan);
  const Scene scene(std::move(world));
  int below = 0;
  for (const Eigen::Isometry3d& T : route.T_town_camera) {
    const Eigen::Vector3d camera = T.translation();
    if (camera.z() > 0.5 || plan.deckDistance(camera.x(), camera.y()) > 3) continue;
    const double up = town::test::distanceTo(scene, camera, Eigen::Vector3d::UnitZ());
    CHECK(up == Approx(apart - kCamera - 0.55).margin(0.1));
    ++below;
  }
  CHECK(below >= 4);
  for (const Deck::Point& point : plan.decks().front().points) {
    CHECK(plan.height(point.position.x(), point.position.y()) < point.height + 0.02);
  }
}

TEST_CASE("houses and trees keep clear of bridges") {
  const CameraRoute route = bridged(crossing(5), kCamera);
  const StreetPlan plan = StreetPlan::grow(route, kCamera).value();
  const World world = buildWorld(plan, {});
  for (const MeshInstance& instance : world.instances) {
    const Vec3& p = instance.placement.position;
    CHECK(plan.deckDistance(static_cast<double>(p.x), static_cast<double>(p.y)) >
          StreetPlan::kRoadHalfWidth);
  }
}

TEST_CASE("KITTI 02 drives the same street 4 m apart: no bridge, and it is levelled", "[data]") {
  const auto file = tolman::test::dataOrSkip("kitti_poses/02.txt");
  if (!file) return;
  const CameraRoute route = bridged(readRoute(*file, {}).value(), kCamera);
  CHECK(raisedFrames(route) == 0);
}
