// SPDX-License-Identifier: BSD-3-Clause
// The hall: the walk, its path without obstacles, and that no ray leaves the hall.
#include "hall.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "drawn_route.hpp"
#include "probe.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

constexpr double kHallCamera = 1.5;

CameraRoute walk() {
  RouteOptions options;
  options.rate = 10;
  options.camera_height = kHallCamera;
  return builtInRoute("hall", options).value();
}

Scene sceneAround(const CameraRoute& route) {
  const StreetPlan plan = StreetPlan::grow(streetBesideHall(route), kHallCamera).value();
  World world = buildWorld(plan, {1, 0.15, 1, false, {hallPlot()}});
  addHall(world, -kHallCamera, 7);
  return Scene(std::move(world));
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace

TEST_CASE("a hand carries the camera twice round, at a walking pace, and looks around") {
  const CameraRoute route = walk();
  CHECK(route.building == Building::Hall);
  CHECK(route.T_town_camera[0].translation().norm() < 1e-9);
  CHECK((route.T_town_camera[0].linear().col(2) - Eigen::Vector3d::UnitY()).norm() < 1e-9);
  double length = 0;
  double lowest = 0;
  double highest = 0;
  double steepest = 0;
  for (std::size_t i = 1; i < route.T_town_camera.size(); ++i) {
    const Eigen::Isometry3d step = route.T_town_camera[i - 1].inverse() * route.T_town_camera[i];
    REQUIRE(step.translation().norm() < 0.2);  // twice the pace
    REQUIRE(degrees(Eigen::AngleAxisd(step.linear()).angle()) < 8);
    length += step.translation().norm();
    const Eigen::Isometry3d& T = route.T_town_camera[i];
    lowest = std::min(lowest, T.translation().z());
    highest = std::max(highest, T.translation().z());
    steepest = std::max(steepest, degrees(std::asin(std::abs(T.linear()(2, 2)))));
  }
  CHECK(length == Approx(52).margin(6));
  CHECK(highest - lowest > 0.4);
  CHECK(steepest > 10);
}

TEST_CASE("the hall is closed, and nothing stands in the way of the camera") {
  const CameraRoute route = walk();
  const Scene scene = sceneAround(route);
  for (std::size_t i = 0; i < route.T_town_camera.size(); i += 3) {
    const Eigen::Vector3d camera = route.T_town_camera[i].translation();
    CAPTURE(i, camera.transpose());
    for (int k = 0; k < 16; ++k) {
      const double angle = 2 * std::numbers::pi * k / 16;
      const Eigen::Vector3d level(std::cos(angle), std::sin(angle), 0);
      const double wall = town::test::distanceTo(scene, camera, level);
      REQUIRE(wall > 0.4);
      REQUIRE(wall < 18);
      REQUIRE(town::test::distanceTo(scene, camera,
                                     (level + Eigen::Vector3d(0, 0, 1)).normalized()) < 18);
    }
    REQUIRE(town::test::distanceTo(scene, camera, -Eigen::Vector3d::UnitZ()) ==
            Approx(kHallCamera + camera.z()).margin(1e-3));
    REQUIRE(town::test::distanceTo(scene, camera, Eigen::Vector3d::UnitZ()) ==
            Approx(Hall::kCeiling - camera.z()).margin(1e-3));
  }
}
