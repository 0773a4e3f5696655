// SPDX-License-Identifier: BSD-3-Clause
// Oncoming cars: on their lane, against the route, at constant speeds.
#include "traffic.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "drawn_route.hpp"
#include "place_of.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::town::test::placeOf;

namespace {

World twoCars() {
  World world;
  world.cars = {3, 4};
  return world;
}

Traffic trafficOn(const CameraRoute& route, const StreetPlan& plan, double density,
                  std::uint32_t seed) {
  World world = twoCars();
  Traffic traffic(route, plan, density, seed, world);
  CHECK(world.instances.size() == traffic.size());
  return traffic;
}

/// Seen by a camera that is far away.
Placement carAt(const Traffic& traffic, std::size_t index, double seconds) {
  return traffic.at(
      index, {seconds, Eigen::Isometry3d(Eigen::Translation3d(9e3, 9e3, 0) *
                                         Eigen::AngleAxisd(1.57, Eigen::Vector3d::UnitX()))});
}

StreetPlan planOf(const CameraRoute& route) {
  return StreetPlan::grow(route, RouteOptions{}.camera_height).value();
}

/// `length` m straight ahead along Y, the ground rising by a tenth.
CameraRoute straight(int length) {
  CameraRoute route;
  for (int i = 0; i <= length; ++i) {
    route.stamps_ns.push_back(std::int64_t{i} * 100'000'000);
    route.T_town_camera.push_back(
        town::test::levelPose({Eigen::Vector2d(0, i), Eigen::Vector2d(0, 1)}, 0.1 * i));
  }
  return route;
}

/// m/s of car `index` between two times that it does not leave the road in.
double speedOf(const Traffic& traffic, std::size_t index, double from, double to) {
  return (placeOf(carAt(traffic, index, to)) - placeOf(carAt(traffic, index, from))).norm() /
         (to - from);
}

}  // namespace

TEST_CASE("on a straight street every car comes down the left lane at its own steady speed") {
  const CameraRoute route = straight(600);
  const StreetPlan plan = planOf(route);
  const Traffic traffic = trafficOn(route, plan, 20, 5);
  REQUIRE(traffic.size() == 12);
  std::vector<double> speeds;
  for (std::size_t i = 0; i < traffic.size(); ++i) {
    const double start = placeOf(carAt(traffic, i, 0)).y();
    CHECK(start >= 50.0 * static_cast<double>(i));  // one car in each twelfth of the street
    CHECK(start < 50.0 * static_cast<double>(i + 1));
    if (start < 30) continue;  // turns over to the far end soon
    const double speed = speedOf(traffic, i, 0, 1);
    CHECK(speed > 6 - 1e-3);
    CHECK(speed < 13 + 1e-3);
    CHECK(speedOf(traffic, i, 1, 2) == Approx(speed).epsilon(1e-3));
    speeds.push_back(speed);
    for (const double t : {0.0, 0.7, 1.9}) {
      const Placement at = carAt(traffic, i, t);
      CHECK(at.position.x == Approx(-2 * StreetPlan::kLaneOffset).margin(1e-4));
      CHECK(at.cosine == Approx(0).margin(1e-5));
      CHECK(at.sine == Approx(-1));
      CHECK(at.position.z == Approx(plan.height(at.position.x, at.position.y)).margin(1e-4));
    }
  }
  std::sort(speeds.begin(), speeds.end());
  CHECK(std::adjacent_find(speeds.begin(), speeds.end()) == speeds.end());
}

TEST_CASE("through bends cars keep their lane and look where they drive") {
  const CameraRoute route = town::test::builtIn("block");
  const StreetPlan plan = planOf(route);
  const Traffic traffic = trafficOn(route, plan, 15, 2);
  REQUIRE(traffic.size() >= 4);
  int in_bends = 0;
  for (std::size_t i = 0; i < traffic.size(); ++i) {
    for (double t = 0; t < 60; t += 0.93) {
      const Placement now = carAt(traffic, i, t);
      const Eigen::Vector2d step = placeOf(carAt(traffic, i, t + 0.02)) - placeOf(now);
      if (step.norm() > 1) continue;  // from the beginning to the end
      double nearest = std::numeric_limits<double>::infinity();
      for (const Eigen::Isometry3d& T : route.T_town_camera) {
        nearest = std::min(nearest, (T.translation().head<2>() - placeOf(now)).norm());
      }
      CAPTURE(i, t);
      REQUIRE(nearest > 2 * StreetPlan::kLaneOffset - 0.1);
      REQUIRE(nearest < 2 * StreetPlan::kLaneOffset + 0.1);
      const Eigen::Vector2d facing(static_cast<double>(now.cosine), static_cast<double>(now.sine));
      REQUIRE(step.normalized().dot(facing) > 0.97);
      in_bends += std::abs(facing.x()) > 0.2 && std::abs(facing.y()) > 0.2;
    }
  }
  CHECK(in_bends > 10);
}

TEST_CASE("a car that would drive through the camera passes beside it") {
  const Eigen::Isometry3d camera =
      town::test::levelPose({Eigen::Vector2d(10, 50), Eigen::Vector2d(0, 1)}, 0);
  const auto moved = [&](double right, double ahead) {
    const Placement car = Placement::at({float(10 + right), float(50 + ahead), 0}, 1.5F);
    return placeOf(besideCamera(car, camera));
  };
  for (const double right : {-2.5, -1.0, 0.0, 1.0, 2.5}) {
    double last = moved(right, -30).x();
    for (double ahead = -30; ahead <= 30; ahead += 0.5) {
      CAPTURE(right, ahead);
      const Eigen::Vector2d p = moved(right, ahead);
      CHECK(p.y() == Approx(50 + ahead));
      if (std::abs(ahead) <= 6) CHECK(std::abs(p.x() - 10) == Approx(3).margin(1e-4));
      if (std::abs(ahead) >= 20) CHECK(p.x() == Approx(10 + right).margin(1e-4));
      CHECK(std::abs(p.x() - last) < 0.25);  // it does not jump
      last = p.x();
    }
  }
  CHECK(moved(-3.4, 0).x() == Approx(6.6));  // the oncoming lane stays as it is
}
