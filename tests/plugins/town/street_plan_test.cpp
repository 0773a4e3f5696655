// SPDX-License-Identifier: BSD-3-Clause
// Streets of a route: the driven path, distances against brute force, one street for several
// passes.
#include "street_plan.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "drawn_route.hpp"
#include "street_path.hpp"
#include "support/data.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::test::dataOrSkip;

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

namespace tolman::town::test {
namespace {

constexpr double kLane = StreetPlan::kLaneOffset;
constexpr double kBeyond = 50;  // m of street beyond either end of a route
constexpr double kCamera = 1.65;

StreetPlan grown(const CameraRoute& route) {
  const Result<StreetPlan> plan = StreetPlan::grow(route, kCamera);
  INFO(plan.status().message());
  REQUIRE(plan.isOk());
  return plan.value();
}

double totalLength(const StreetPlan& plan) {
  double total = 0;
  for (const StreetSection& section : plan.sections()) total += section.points.back().s;
  return total;
}

/// m by which a camera is not at kCamera above the road, the largest one.
double worstHeight(const CameraRoute& route, const StreetPlan& plan) {
  double worst = 0;
  for (const Eigen::Isometry3d& pose : route.T_town_camera) {
    const Eigen::Vector3d at = pose.translation();
    worst = std::max(worst, std::abs(at.z() - plan.height(at.x(), at.y()) - kCamera));
  }
  return worst;
}

double farthestFromCentre(const CameraRoute& route, const StreetPlan& plan) {
  double farthest = 0;
  for (const Eigen::Isometry3d& pose : route.T_town_camera) {
    farthest = std::max(farthest, plan.distance(pose.translation().x(), pose.translation().y()));
  }
  return farthest;
}

/// From the poses themselves: each shifted to the left by half a street.
std::vector<Eigen::Vector2d> centresOf(const CameraRoute& route) {
  std::vector<Eigen::Vector2d> centres;
  for (const Eigen::Isometry3d& pose : route.T_town_camera) {
    const Eigen::Vector3d left = -pose.linear().col(0);
    centres.emplace_back((pose.translation() + kLane * left).head<2>());
  }
  return centres;
}

double bruteForceDistance(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& at) {
  double nearest = StreetPlan::kFarthest;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Eigen::Vector2d along = line[i + 1] - line[i];
    const double t = std::clamp((at - line[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (at - line[i] - t * along).norm());
  }
  return nearest;
}

LanePath straight(double length) {
  LanePath path(kLane);
  path.ahead(length);
  return path;
}

/// Out, round a roundabout, and back on the other lane.
LanePath thereAndBack(double length) {
  LanePath path(kLane);
  path.ahead(length).roundabout(11, 10, std::numbers::pi).ahead(length);
  return path;
}

/// A loop over its own start, where the second pass is `step` m higher.
CameraRoute loopWithStep(double step) {
  LanePath path(kLane);
  path.ahead(60);
  for (int corner = 0; corner < 3; ++corner) path.turnRight(7).ahead(100);
  path.turnRight(7).ahead(100);
  const double length = path.length();
  return drawnRoute(path, [=](double s) {
    const double t = std::clamp((s - 150) / (length - 300), 0.0, 1.0);
    return step * t * t * (3 - 2 * t);
  });
}

}  // namespace

TEST_CASE("a straight drive has one street to its left that goes on beyond both ends") {
  const StreetPlan plan = grown(drawnRoute(straight(100)));
  REQUIRE(plan.sections().size() == 1);
  const std::vector<StreetPoint>& points = plan.sections()[0].points;
  CHECK(points.back().s == Approx(100 + 2 * kBeyond).margin(1));
  for (std::size_t i = 0; i < points.size(); ++i) {
    REQUIRE(points[i].s == Approx(static_cast<double>(i)));
    REQUIRE((points[i].position - Eigen::Vector2d(-kLane, points[i].s - kBeyond)).norm() < 1e-6);
    REQUIRE((points[i].direction - Eigen::Vector2d(0, 1)).norm() < 1e-9);
  }
}

TEST_CASE("beside a straight street the distance is that to a line, and ends at kFarthest") {
  const StreetPlan plan = grown(drawnRoute(straight(100)));
  for (double x = -55; x < 55; x += 0.83) {
    const double exact = std::abs(x + kLane);
    if (exact > 0.5) CHECK(plan.distance(x, 50.2) == Approx(exact).margin(1e-4));
  }
  CHECK(plan.distance(0, 30) < kLane + 0.2);
  CHECK(plan.distance(500, 30) == StreetPlan::kFarthest);
  CHECK(plan.distance(-kLane, 150 + 20) ==
        Approx(20).margin(0.05));  // beyond the end of the street
}

TEST_CASE("distances agree with brute force over the poses to 5 cm") {
  const CameraRoute route = builtIn("block", 20);
  const StreetPlan plan = grown(route);
  const std::vector<Eigen::Vector2d> line = centresOf(route);
  std::mt19937 random(7);
  std::vector<double> errors;
  for (int i = 0; i < 4000; ++i) {
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    const Eigen::Vector2d size = plan.highCorner() - plan.lowCorner();
    const Eigen::Vector2d at =
        plan.lowCorner() + Eigen::Vector2d(uniform() * size.x(), uniform() * size.y());
    errors.push_back(std::abs(plan.distance(at.x(), at.y()) - bruteForceDistance(line, at)));
  }
  std::sort(errors.begin(), errors.end());
  CHECK(errors[errors.size() * 98 / 100] < 0.05);
  CHECK(errors.back() < 0.2);  // on the ridge of the field, in the middle of road and block
}

TEST_CASE("every camera drives between the kerbs, on its road, on all built-in routes",
          "[figures]") {
  for (const char* name : {"block", "eights", "district"}) {
    const CameraRoute route = builtIn(name);
    const StreetPlan plan = grown(route);
    CHECK(farthestFromCentre(route, plan) < StreetPlan::kRoadHalfWidth - 1);
    CHECK(worstHeight(route, plan) < 0.05);
  }
}

TEST_CASE("a street that is driven twice is built once") {
  // The centreline of block is a loop: perimeter, less what four corners of its radius cut off.
  const StreetPlan block = grown(builtIn("block"));
  CHECK(block.sections().size() == 1);
  const double bulge_more = 4 * 30 * (0.28 - std::sin(0.28));
  CHECK(
      totalLength(block) ==
      Approx(2 * (80 + 65) - 4 * (2 - std::numbers::pi / 2) * (7 + kLane) + bulge_more).margin(8));

  // eights drives every street of its two loops at least twice.
  const CameraRoute eights = builtIn("eights");
  CHECK(totalLength(grown(eights)) < 0.55 * static_cast<double>(763));
}

TEST_CASE("the way back on the opposite lane is the same street") {
  const StreetPlan plan = grown(drawnRoute(thereAndBack(120)));
  // Out to the roundabout, round it, and a bit of doubt where the arms meet.
  CHECK(totalLength(plan) < 120 + kBeyond + 2 * std::numbers::pi * 11 + 10);
  CHECK(totalLength(plan) > 120);
  REQUIRE_FALSE(plan.sections().empty());
  for (const StreetPoint& point : plan.sections()[0].points) {
    if (point.s < 100) REQUIRE(point.direction.y() > 0.99);
  }
}

TEST_CASE("hills and crests are followed to centimetres, level across the street") {
  const CameraRoute route = drawnRoute(
      straight(300), [](double s) { return 3 * std::sin(s / 25) + 0.02 * s; });  // up to 14 %
  const StreetPlan plan = grown(route);
  CHECK(worstHeight(route, plan) < 0.04);
  for (double y = 20; y < 280; y += 11) {
    for (const double x : {-kLane - 5.5, -kLane, 3.5}) {
      CHECK(plan.height(x, y) == Approx(plan.height(0, y)).margin(0.02));
    }
  }
}

TEST_CASE("passes that disagree about the height meet in the middle and part gently") {
  for (const double step : {0.6, -1.2}) {
    const CameraRoute route = loopWithStep(step);
    const StreetPlan plan = grown(route);
    // 40 m of the start are driven twice: there the road takes the mean ...
    CHECK(plan.height(0, 20) == Approx(step / 2 - kCamera).margin(0.06));
    // ... far from there it lies under the camera ...
    const Eigen::Vector3d half_way = route.T_town_camera[200].translation();
    CHECK(half_way.z() - plan.height(half_way.x(), half_way.y()) == Approx(kCamera).margin(0.02));
    // ... and nowhere is the road more than 5 % steeper than the drive.
    for (std::size_t i = 1; i < route.T_town_camera.size(); ++i) {
      const Eigen::Vector3d a = route.T_town_camera[i - 1].translation();
      const Eigen::Vector3d b = route.T_town_camera[i].translation();
      const double error = plan.height(b.x(), b.y()) - plan.height(a.x(), a.y()) - b.z() + a.z();
      REQUIRE(std::abs(error) < 0.05);
    }
  }
}

TEST_CASE("the ground is continuous, from the road to the horizon", "[figures]") {
  const CameraRoute route = builtIn("district");
  const StreetPlan plan = grown(route);
  const Eigen::Vector2d centre = (plan.lowCorner() + plan.highCorner()) / 2;
  for (double angle = 0; angle < 2 * std::numbers::pi; angle += 0.3) {
    const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
    double before = plan.height(centre.x(), centre.y());
    for (double r = 0.1; r < 700; r += 0.1) {
      const Eigen::Vector2d at = centre + r * out;
      const double height = plan.height(at.x(), at.y());
      REQUIRE(std::abs(height - before) < 0.05);
      REQUIRE(std::abs(height) < 15);
      before = height;
    }
  }
}

TEST_CASE("a camera that leaves the ground is refused") {
  CameraRoute route = drawnRoute(straight(100));
  route.T_town_camera[60].translation().z() = 4.5;
  for (std::size_t i = 59; i < 62; i += 2) route.T_town_camera[i].translation().z() = -4;
  const Result<StreetPlan> plan = StreetPlan::grow(route, kCamera);
  REQUIRE_FALSE(plan.isOk());
  CHECK(plan.status().message().find("m above the road (0.5 to 4.0 m is possible); choose a route "
                                     "that keeps to the ground") != std::string::npos);
}

TEST_CASE("driving backwards into land that was never driven forwards is refused") {
  CameraRoute route = drawnRoute(straight(60));
  for (int i = 0; i < 120; ++i) {
    Eigen::Isometry3d pose = route.T_town_camera.front();
    pose.translation().y() = 60 - i;
    pose.translation().x() = 0.2 * i;
    route.T_town_camera.push_back(pose);
    route.stamps_ns.push_back(0);
  }
  const Result<StreetPlan> plan = StreetPlan::grow(route, kCamera);
  REQUIRE_FALSE(plan.isOk());
  CHECK(plan.status().message().ends_with(
      "the car leaves the street backwards or sideways; choose a route that is driven forwards"));
}

TEST_CASE("routes without poses, heights or bounds are refused") {
  CHECK(StreetPlan::grow(CameraRoute{}, kCamera).status().message() == "the route has no pose");
  CHECK(StreetPlan::grow(drawnRoute(straight(12500)), kCamera).status().message() ==
        "the route extends over 12.7 km, more than 12 km; choose a shorter one");
}

TEST_CASE("towns grow around KITTI's drives", "[data]") {
  struct Drive {
    const char* file;
    double most_streets;  // m: clearly less than driven
    double disagreement;  // m: half of what its passes differ in height, and what smoothing takes
  };
  for (const Drive& drive : {Drive{"00.txt", 3150, 0.9}, Drive{"05.txt", 2050, 0.4},
                             Drive{"06.txt", 1000, 0.2}, Drive{"07.txt", 760, 0.25}}) {
    const auto file = dataOrSkip(std::string("kitti_poses/") + drive.file);
    if (!file) return;
    const CameraRoute route = readRoute(*file, {}).value();
    const StreetPlan plan = grown(route);
    CHECK(farthestFromCentre(route, plan) < StreetPlan::kRoadHalfWidth - 1);
    CHECK(worstHeight(route, plan) < drive.disagreement);
    CHECK(totalLength(plan) < drive.most_streets);
  }
}

}  // namespace tolman::town::test
