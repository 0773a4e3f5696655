// SPDX-License-Identifier: BSD-3-Clause
// Lane paths compared with closed forms, and limits of a car on the built-in routes.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "drawn_route.hpp"
#include "street_plan.hpp"

namespace tolman::town::test {
namespace {

constexpr double kShapeLane = 1.7;
constexpr std::array<const char*, 4> kNames = {"block", "eights", "district", "highway"};

Eigen::Vector3d place(const CameraRoute& route, std::size_t i) {
  return route.T_town_camera[i].translation();
}

Eigen::Vector2d heading(const CameraRoute& route, std::size_t i) {
  return route.T_town_camera[i].linear().col(2).head<2>().normalized();
}

double drivenLength(const CameraRoute& route) {
  double length = 0;
  for (std::size_t i = 1; i < route.T_town_camera.size(); ++i) {
    length += (place(route, i) - place(route, i - 1)).norm();
  }
  return length;
}

/// Frames that come back to within `reach` of a pose at least 200 frames before, with the cosine
/// between headings in [low, high].
int countRevisits(const CameraRoute& route, double reach, double low, double high) {
  int count = 0;
  for (std::size_t i = 200; i < route.T_town_camera.size(); ++i) {
    for (std::size_t j = 0; j + 200 <= i; ++j) {
      const double cosine = heading(route, i).dot(heading(route, j));
      if ((place(route, i) - place(route, j)).norm() < reach && cosine >= low && cosine <= high) {
        ++count;
        break;
      }
    }
  }
  return count;
}

}  // namespace

TEST_CASE("a lane path goes straight on from the origin along Y") {
  LanePath path(kShapeLane);
  path.ahead(30).ahead(12);
  CHECK(path.length() == Approx(42));
  CHECK((path.at(17).position - Eigen::Vector2d(0, 17)).norm() < 1e-12);
  CHECK((path.at(17).direction - Eigen::Vector2d(0, 1)).norm() < 1e-12);
  CHECK((path.at(100).position - Eigen::Vector2d(0, 42)).norm() < 1e-12);
  CHECK(path.curvature(17) == 0);
}

TEST_CASE("a full circle of street leads the lane back to where it began") {
  for (const double angle : {2 * std::numbers::pi, -2 * std::numbers::pi}) {
    LanePath path(kShapeLane);
    path.curve(20, angle);
    CHECK(path.length() ==
          Approx(2 * std::numbers::pi * (20 + (angle > 0 ? kShapeLane : -kShapeLane))));
    CHECK(path.at(path.length()).position.norm() < 1e-9);
    const Eigen::Vector2d centre(angle > 0 ? -20 - kShapeLane : 20 - kShapeLane, 0);
    for (double s = 0; s < path.length(); s += 3) {
      CHECK((path.at(s).position - centre).norm() == Approx(centre.norm()));
    }
  }
}

TEST_CASE("four turns round a block of any radii close by the lengths of its streets") {
  for (const double side : {-1.0, 1.0}) {
    LanePath path(kShapeLane);
    const auto turn = [&](double radius) {
      side < 0 ? path.turnRight(radius) : path.turnLeft(radius);
    };
    path.ahead(30);
    turn(6);
    path.ahead(50);
    turn(9);
    path.ahead(70);
    turn(5);
    path.ahead(50);
    turn(8);
    path.ahead(40);
    CHECK(path.at(path.length()).position.norm() < 1e-9);
    CHECK((path.at(path.length()).direction - Eigen::Vector2d(0, 1)).norm() < 1e-9);
  }
}

TEST_CASE("a bulge comes back to its line, 4 r sin(angle) on") {
  for (const double angle : {0.3, -0.3}) {
    LanePath path(kShapeLane);
    path.bulge(40, angle);
    const LanePosition end = path.at(path.length());
    CHECK(std::abs(end.position.x()) < 1e-9);
    CHECK(end.position.y() == Approx(4 * 40 * std::sin(0.3)));
    CHECK(path.at(path.length() / 2).position.x() * angle < 0);  // a left bend begins to the left
  }
}

TEST_CASE("a roundabout keeps its radius and leaves where it is told") {
  for (const double angle : {0.0, std::numbers::pi / 2, std::numbers::pi}) {
    LanePath path(kShapeLane);
    path.ahead(50).roundabout(11, 10, angle).ahead(50);
    // Both arms lie right of their street's centreline; the island is 50 m ahead on it.
    const Eigen::Vector2d island(-kShapeLane, 50);
    const Eigen::Vector2d out(-std::sin(angle), std::cos(angle));
    const Eigen::Vector2d expected =
        island + 50 * out + kShapeLane * Eigen::Vector2d(out.y(), -out.x());
    const LanePosition end = path.at(path.length());
    CHECK((end.position - expected).norm() < 1e-9);
    CHECK((end.direction - out).norm() < 1e-9);
    double nearest = 1e9;
    double round = 0;
    for (double s = 0; s < path.length(); s += 0.01) {
      nearest = std::min(nearest, (path.at(s).position - island).norm());
      if (path.curvature(s) > 0) round += 0.01 * path.curvature(s);
    }
    CHECK(nearest == Approx(11).margin(1e-3));
    if (angle == std::numbers::pi) CHECK(round > 1.5 * std::numbers::pi);
  }
}

TEST_CASE("direction and curvature are the derivatives of the position") {
  LanePath path(kShapeLane);
  path.ahead(20).turnRight(6).ahead(40).bulge(30, 0.2).ahead(30).roundabout(11, 10,
                                                                            std::numbers::pi / 2);
  path.ahead(30).turnLeft(9).ahead(30);
  constexpr double h = 1e-4;
  for (double s = 0.5; s < path.length() - 1; s += 0.37) {
    const LanePosition before = path.at(s - h);
    const LanePosition after = path.at(s + h);
    CHECK(((after.position - before.position) / (2 * h) - path.at(s).direction).norm() < 1e-4);
    if (path.curvature(s - h) != path.curvature(s + h)) continue;
    const double turned =
        before.direction.x() * after.direction.y() - before.direction.y() * after.direction.x();
    CHECK(turned / (2 * h) == Approx(path.curvature(s)).margin(1e-6));
  }
}

TEST_CASE("a street that is shorter than its turns is a mistake in the route") {
  LanePath path(kShapeLane);
  path.ahead(20).turnRight(9).ahead(15);
  CHECK_THROWS_AS(path.turnRight(9), std::invalid_argument);
  LanePath narrow(kShapeLane);
  CHECK_THROWS_AS(narrow.ahead(50).roundabout(1, 10, 0), std::invalid_argument);
}

TEST_CASE("built-in routes begin at the origin, looking along Y") {
  Eigen::Matrix3d R_town_camera;
  R_town_camera << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  for (const char* name : kNames) {
    const CameraRoute route = builtIn(name);
    CHECK(route.name == name);
    CHECK(place(route, 0).norm() < 1e-12);
    CHECK((route.T_town_camera[0].linear() - R_town_camera).norm() < 1e-12);
    REQUIRE(route.stamps_ns.size() == route.T_town_camera.size());
    for (std::size_t i = 0; i < route.stamps_ns.size(); ++i) {
      REQUIRE(route.stamps_ns[i] == static_cast<std::int64_t>(i) * 100'000'000);
    }
  }
}

TEST_CASE("built-in routes are as long as they promise") {
  CHECK(drivenLength(builtIn("block")) == Approx(300).margin(15));
  CHECK(drivenLength(builtIn("eights")) == Approx(770).margin(30));
  CHECK(drivenLength(builtIn("district")) == Approx(1050).margin(60));
  CHECK(drivenLength(builtIn("highway")) == Approx(1420).margin(60));
  // Faster cameras see the same way.
  CHECK(drivenLength(builtIn("district", 40)) ==
        Approx(drivenLength(builtIn("district"))).epsilon(0.002));
}

TEST_CASE("the car never jumps, slides, or leans") {
  for (const char* name : kNames) {
    const CameraRoute route = builtIn(name);
    for (std::size_t i = 1; i < route.T_town_camera.size(); ++i) {
      const Eigen::Vector3d step = place(route, i) - place(route, i - 1);
      REQUIRE(step.norm() < 8 / 10. * 1.01);
      REQUIRE(step.norm() > 0.1);
      const Eigen::Matrix3d R = route.T_town_camera[i].linear();
      REQUIRE((R.transpose() * R - Eigen::Matrix3d::Identity()).norm() < 1e-9);
      REQUIRE(R.determinant() == Approx(1));
      REQUIRE(std::abs(R(2, 0)) < 1e-12);  // no roll
      REQUIRE(std::abs(R(2, 2)) < 0.06);   // slope of the street
      const Eigen::Vector2d mean = (heading(route, i) + heading(route, i - 1)).normalized();
      REQUIRE(mean.dot(step.head<2>().normalized()) > std::cos(0.02));
      REQUIRE(step.z() / step.head<2>().norm() == Approx(R(2, 2)).margin(0.02));
    }
  }
}

TEST_CASE("passengers are comfortable: 1.5 m/s^2 in bends and before them") {
  for (const char* name : kNames) {
    const CameraRoute route = builtIn(name, 20);
    double lateral = 0;
    double longitudinal = 0;
    for (std::size_t i = 1; i + 1 < route.T_town_camera.size(); ++i) {
      const Eigen::Vector2d acceleration =
          (place(route, i + 1) - 2 * place(route, i) + place(route, i - 1)).head<2>() * 20 * 20;
      const Eigen::Vector2d forward = heading(route, i);
      longitudinal = std::max(longitudinal, std::abs(acceleration.dot(forward)));
      lateral =
          std::max(lateral, std::abs(acceleration.dot(Eigen::Vector2d(-forward.y(), forward.x()))));
    }
    CHECK(lateral < 1.6);
    if (name != std::string("highway")) CHECK(lateral > 1.3);  // its bends are wide
    CHECK(longitudinal < 1.6);
    CHECK(longitudinal > 1.3);
    const double start_speed = (place(route, 1) - place(route, 0)).norm() * 20;
    CHECK(start_speed == Approx(4).margin(0.1));
  }
}

TEST_CASE("block closes its loop in the same direction") {
  const CameraRoute route = builtIn("block");
  CHECK(countRevisits(route, 0.5, 0.99, 1) > 30);
  CHECK(countRevisits(route, 5, -1, -0.9) == 0);
  // Only the last 40 m are a repetition.
  CHECK(countRevisits(route, 0.5, -1, 1) < 90);
}

TEST_CASE("eights crosses itself at a right angle and repeats every loop") {
  const CameraRoute route = builtIn("eights");
  CHECK(countRevisits(route, 0.5, -0.1, 0.1) > 0);
  CHECK(countRevisits(route, 0.5, 0.99, 1) > static_cast<int>(route.stamps_ns.size()) * 4 / 10);
}

TEST_CASE("district comes back both ways") {
  const CameraRoute route = builtIn("district");
  CHECK(countRevisits(route, 0.5, 0.99, 1) > 150);
  CHECK(countRevisits(route, 2 * kShapeLane + 0.1, -1, -0.99) > 300);
}

TEST_CASE("heights are those of one ground wherever passes meet") {
  for (const char* name : kNames) {
    const CameraRoute route = builtIn(name);
    for (std::size_t i = 0; i < route.stamps_ns.size(); ++i) {
      for (std::size_t j = i + 200; j < route.stamps_ns.size(); ++j) {
        const Eigen::Vector3d apart = place(route, i) - place(route, j);
        if (apart.head<2>().norm() < 0.3) REQUIRE(std::abs(apart.z()) < 0.13);
      }
    }
  }
}

TEST_CASE("a route that is not there is refused with those that are") {
  const auto refused = builtInRoute("circle", {});
  REQUIRE_FALSE(refused.isOk());
  CHECK(refused.status().code() == StatusCode::InvalidParameter);
  CHECK(refused.status().message() ==
        "there is no route 'circle'; use block, eights, district, highway, car_park, hall, or a "
        "KITTI "
        ""
        "pose file");
}

TEST_CASE("options that no car can drive are refused") {
  RouteOptions options;
  options.rate = 0;
  CHECK(builtInRoute("block", options).status().message() ==
        "rate must be positive; give frames/s");
  options = {};
  options.speed = -3;
  CHECK(builtInRoute("block", options).status().message() == "speed must be positive; give m/s");
  options = {};
  options.camera_height = std::nan("");
  CHECK(builtInRoute("block", options).status().message() ==
        "camera_height must be positive; give metres above the road");
}

TEST_CASE("a slow car needs more frames for the same way, a racing one brakes for bends") {
  RouteOptions options;
  options.speed = 2;
  const CameraRoute slow = builtInRoute("block", options).value();
  options.speed = 100;
  const CameraRoute fast = builtInRoute("block", options).value();
  CHECK(drivenLength(slow) == Approx(drivenLength(fast)).epsilon(0.01));
  CHECK(slow.stamps_ns.size() > 2 * fast.stamps_ns.size());
  CHECK(fast.stamps_ns.size() > 300);
}

}  // namespace tolman::town::test
