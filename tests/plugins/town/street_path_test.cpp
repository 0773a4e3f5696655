// SPDX-License-Identifier: BSD-3-Clause
// The driven path: even spacing, the centreline to its left, other passes, and the grid of points
// against brute force.
#include "street_path.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "drawn_route.hpp"
#include "street_plan.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

std::vector<PathPoint> drivenOver(std::vector<PathPoint> path) {
  std::erase_if(path, [](const PathPoint& p) { return !p.driven_over; });
  return path;
}

PathPoint pointAt(double s, double x, double degrees) {
  const double angle = degrees * 3.14159265358979 / 180;
  PathPoint point;
  point.s = s;
  point.centre = {x, 0};
  point.direction = {std::cos(angle), std::sin(angle)};
  return point;
}

}  // namespace

TEST_CASE("points lie a metre apart on the path, whatever the frame rate") {
  for (const double rate : {3.0, 10.0, 50.0}) {
    const CameraRoute route = town::test::builtIn("block", rate);
    const std::vector<PathPoint> path = drivenOver(samplePath(route, 1.65));
    REQUIRE(path.size() > 250);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const double step = (path[i + 1].driven - path[i].driven).norm();
      CAPTURE(rate, i);
      REQUIRE(step < 1 + 1e-9);
      if (i + 2 < path.size()) REQUIRE(step > 0.93);  // the chord of a bend
      REQUIRE(path[i + 1].s > path[i].s);
      double nearest = 1e9;  // the poses' own polyline is at most a pose away
      for (const Eigen::Isometry3d& T : route.T_town_camera) {
        nearest = std::min(nearest, (T.translation().head<2>() - path[i].driven).norm());
      }
      REQUIRE(nearest < std::max(0.5, 4.5 / rate));
    }
  }
}

TEST_CASE("the centreline is a lane's offset to the left, the road a camera's height below") {
  const CameraRoute route = town::test::builtIn("district");
  for (const PathPoint& point : samplePath(route, 2.5)) {
    const Eigen::Vector2d left(-point.direction.y(), point.direction.x());
    REQUIRE(point.direction.norm() == Approx(1));
    REQUIRE((point.centre - point.driven - StreetPlan::kLaneOffset * left).norm() < 1e-9);
  }
  const std::vector<PathPoint> low = samplePath(route, 1);
  const std::vector<PathPoint> high = samplePath(route, 2.5);
  REQUIRE(low.size() == high.size());
  for (std::size_t i = 0; i < low.size(); ++i) {
    REQUIRE(low[i].height - high[i].height == Approx(1.5));
  }
}

TEST_CASE("a straight street goes on for 50 m beyond either end, its slope fading out") {
  CameraRoute route;
  for (int i = 0; i <= 100; ++i) {
    route.stamps_ns.push_back(i);
    route.T_town_camera.push_back(
        town::test::levelPose({Eigen::Vector2d(0, i), Eigen::Vector2d(0, 1)}, 0.1 * i));
  }
  const std::vector<PathPoint> path = samplePath(route, 0);
  CHECK(path.front().driven.y() == Approx(-50));
  CHECK(path.back().driven.y() == Approx(150));
  CHECK(path.front().s == Approx(-50));
  double steepest = 0.1 + 1e-9;
  for (std::size_t i = path.size() - 50; i < path.size(); ++i) {
    REQUIRE_FALSE(path[i].driven_over);
    const double slope = path[i].height - path[i - 1].height;
    REQUIRE(slope >= 0);
    REQUIRE(slope <= steepest);
    steepest = slope;
  }
  CHECK(steepest < 0.015);
}

TEST_CASE("passes are other ones after 30 m, and on the way back after 10 m") {
  struct Case {
    double apart_s, apart_x, degrees;
    bool other, same_street;
  };
  for (const Case& c : {Case{5, 0, 0, false, false},
                        {29, 3, 0, false, false},
                        {31, 3, 0, true, true},
                        {31, 4.5, 34, true, true},
                        {31, 3, 36, true, false},
                        {31, 3, 90, true, false},
                        {31, 5.5, 0, true, false},
                        {9, 3, 180, false, false},
                        {11, 3, 180, true, true},
                        {11, 3, 146, true, true},
                        {11, 3, 144, false, false},
                        {31, 3, 144, true, false}}) {
    const PathPoint a = pointAt(100, 0, 10);
    const PathPoint b = pointAt(100 + c.apart_s, c.apart_x, 10 + c.degrees);
    CAPTURE(c.apart_s, c.apart_x, c.degrees);
    CHECK(isOtherPass(a, b) == c.other);
    CHECK(isOtherPass(b, a) == c.other);
    CHECK(isSameStreet(a, b, 5) == c.same_street);
    CHECK(isSameStreet(b, a, 5) == c.same_street);
  }
}

TEST_CASE("the grid finds every point within its reach, on both sides of zero") {
  RandomStream random(21);
  PointGrid grid;
  std::vector<Eigen::Vector2d> places;
  for (std::size_t i = 0; i < 800; ++i) {
    places.emplace_back(random.uniform(-120, 120), random.uniform(-120, 120));
    grid.add(places.back(), i);
  }
  std::size_t most = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d place(random.uniform(-125, 125), random.uniform(-125, 125));
    const std::vector<std::size_t> found = grid.near(place);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double apart = (places[k] - place).norm();
      const auto times = std::count(found.begin(), found.end(), k);
      REQUIRE(times <= 1);
      if (apart <= PointGrid::kReach) REQUIRE(times == 1);
      if (times == 1) REQUIRE(apart < 3 * PointGrid::kReach);
    }
    most = std::max(most, found.size());
  }
  CHECK(most > 5);
  CHECK(PointGrid().near({0, 0}).empty());
}
