// SPDX-License-Identifier: BSD-3-Clause
// Routes: shapes compared with closed forms, built-in ones, pose files, levelled and flown ones.
#include "route.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "drawn_route.hpp"
#include "street_plan.hpp"
#include "support/context.hpp"
#include "support/data.hpp"
#include "town_source.hpp"

using tolman::test::dataOrSkip;
using tolman::test::TemporaryFolder;
using namespace tolman;
using namespace tolman::town;
using namespace tolman::town::test;

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

TEST_CASE("a route that is not there is refused with those that are") {
  const auto refused = builtInRoute("circle", {});
  REQUIRE_FALSE(refused.isOk());
  CHECK(refused.status().code() == StatusCode::InvalidParameter);
  CHECK(refused.status().message() ==
        "there is no route 'circle'; use block, eights, district, highway, car_park, hall, or a "
        "KITTI pose file");
}

}  // namespace tolman::town::test

namespace tolman::town::test {
namespace {

const std::string kStart = "1 0 0 0 0 1 0 0 0 0 1 0\n";
const std::string kOneAhead = "1 0 0 0 0 1 0 0 0 0 1 1\n";

class PoseFile {
 public:
  explicit PoseFile(const std::string& text) : path_(folder_.path() / "drive.txt") {
    std::ofstream(path_) << text;
  }
  Result<CameraRoute> read(double rate = 10) const {
    RouteOptions options;
    options.rate = rate;
    return readRoute(path_, options);
  }
  /// The message without the folder.
  std::string refusal(double rate = 10) const {
    const Result<CameraRoute> route = read(rate);
    if (route.isOk()) return "read";
    CHECK(route.status().code() == StatusCode::InvalidInput);
    const std::string message = route.status().message();
    const std::string folder = folder_.path().string() + "/";
    return message.starts_with(folder) ? message.substr(folder.size()) : message;
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path path_;
};

std::string kittiLine(const Eigen::Isometry3d& T) {
  std::ostringstream line;
  line << std::setprecision(17);
  for (int i = 0; i < 12; ++i) line << (i > 0 ? " " : "") << T.matrix()(i / 4, i % 4);
  return line.str() + "\n";
}

}  // namespace

TEST_CASE("the first pose of a file is the origin of the town, camera forward is Y, down is -Z") {
  const PoseFile file(kStart + "1 0 0 0.2 0 1 0 -0.1 0 0 1 1.5\n");
  const CameraRoute route = file.read().value();
  CHECK(route.name == "drive");
  REQUIRE(route.T_town_camera.size() == 2);
  CHECK(route.T_town_camera[0].translation().norm() < 1e-12);
  CHECK((route.T_town_camera[0] * Eigen::Vector3d(1, 2, 3) - Eigen::Vector3d(1, 3, -2)).norm() <
        1e-12);
  CHECK((route.T_town_camera[1].translation() - Eigen::Vector3d(0.2, 1.5, 0.1)).norm() < 1e-12);
}

TEST_CASE("a built-in route comes back from its file, whatever frame that was written in") {
  const CameraRoute block = builtIn("block");
  Eigen::Isometry3d T_world_town = Eigen::Isometry3d::Identity();
  T_world_town.rotate(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()));
  T_world_town.pretranslate(Eigen::Vector3d(400, -30, 7));
  std::string text;
  for (const Eigen::Isometry3d& T : block.T_town_camera) text += kittiLine(T_world_town * T);
  const CameraRoute read = PoseFile(text).read().value();
  REQUIRE(read.T_town_camera.size() == block.T_town_camera.size());
  CHECK(read.stamps_ns == block.stamps_ns);
  for (std::size_t i = 0; i < read.T_town_camera.size(); ++i) {
    REQUIRE(read.T_town_camera[i].isApprox(block.T_town_camera[i], 1e-9));
  }
}

TEST_CASE("rotations that print few digits are made orthogonal") {
  const PoseFile file(kStart + "0.9998 0.0199 0 0 -0.0199 0.9998 0 0 0 0 1 1\n");
  const Eigen::Matrix3d R = file.read().value().T_town_camera[1].linear();
  CHECK((R.transpose() * R - Eigen::Matrix3d::Identity()).norm() < 1e-12);
}

TEST_CASE("files without a drive are refused") {
  RouteOptions options;
  CHECK(readRoute("/nowhere/drive.txt", options).status().message() ==
        "/nowhere/drive.txt: there is no such file; correct the path, or use block, eights, "
        "district, highway or car_park");
  CHECK(PoseFile("").refusal() == "drive.txt: has no pose; a drive needs two or more");
  CHECK(PoseFile("\n\n").refusal() == "drive.txt: has no pose; a drive needs two or more");
  CHECK(PoseFile(kStart).refusal() == "drive.txt: has one pose; a drive needs two or more");
  const TemporaryFolder folder;
  for (const std::string& other : {folder.path().string(), std::string("/dev/null")}) {
    CHECK(readRoute(other, options).status().message() ==
          other + ": is a folder or device; give a KITTI pose file");
  }
}

TEST_CASE("lines that are no pose are refused with their number") {
  CHECK(PoseFile(kStart + "1 0 0 0 0 1 0 0 0 0 1\n").refusal() ==
        "drive.txt:2: has 11 numbers; a pose has 12, row by row");
  CHECK(PoseFile(kStart + "\n0 1 0 0 0 0 1 0 0 0 0 1 0\n").refusal() ==
        "drive.txt:3: has 13 numbers; a pose has 12, row by row");
  CHECK(PoseFile("1 0 0 nan 0 1 0 0 0 0 1 0\n").refusal() ==
        "drive.txt:1: 'nan' is no finite number; correct the pose");
  CHECK(PoseFile("1 0 0 -inf 0 1 0 0 0 0 1 0\n").refusal() ==
        "drive.txt:1: '-inf' is no finite number; correct the pose");
  CHECK(PoseFile("1 0 0 1e999 0 1 0 0 0 0 1 0\n").refusal() ==
        "drive.txt:1: '1e999' is too large for a double; correct the pose");
  CHECK(PoseFile("1 0 0 3.5m 0 1 0 0 0 0 1 0\n").refusal() ==
        "drive.txt:1: '3.5m' is no finite number; correct the pose");
}

TEST_CASE("matrices that are no rotation are refused") {
  const std::string message =
      "drive.txt:2: its first three columns are no rotation; write camera-to-world poses";
  CHECK(PoseFile(kStart + "2 0 0 0 0 2 0 0 0 0 2 0\n").refusal() == message);
  CHECK(PoseFile(kStart + "-1 0 0 0 0 1 0 0 0 0 1 0\n").refusal() == message);  // a mirror
  CHECK(PoseFile(kStart + "0 0 0 0 0 0 0 0 0 0 0 0\n").refusal() == message);
  CHECK(PoseFile(kStart + "1 0.01 0 0 0 1 0 0 0 0 1 0\n").refusal() == message);
}

TEST_CASE("jumps that no car drives are refused") {
  const std::string far = "1 0 0 0 0 1 0 0 0 0 1 12.5\n";
  CHECK(PoseFile(kStart + far).refusal() ==
        "drive.txt:2: is 12.5 m from the pose before, farther than a car drives in 0.100 s "
        "(6.0 m); remove the jump, or correct the frame rate");
  CHECK(PoseFile(kStart + far).refusal(2) == "read");  // 25 m/s
  CHECK(PoseFile(kStart + "1 0 0 0 0 1 0 0 0 0 1 4.9\n").refusal(100) == "read");
  CHECK(PoseFile(kStart + "0 0 1 0 0 1 0 0 -1 0 0 1\n").refusal() ==
        "drive.txt:2: is turned by 90 degrees from the pose before, more than 60; remove the jump, "
        "or correct the frame rate");
  CHECK(
      PoseFile(kStart + "1 0 0 1e300 0 1 0 0 0 0 1 0\n").refusal().starts_with("drive.txt:2: is "));
}

TEST_CASE("KITTI's drives are read whole", "[data]") {
  struct Drive {
    const char* file;
    std::size_t frames;
    double length;  // m, as published: 3724, 2206, 1233, 695
  };
  for (const Drive& drive : {Drive{"00.txt", 4541, 3724}, Drive{"05.txt", 2761, 2206},
                             Drive{"06.txt", 1101, 1233}, Drive{"07.txt", 1101, 695}}) {
    const auto file = dataOrSkip(std::string("kitti_poses/") + drive.file);
    if (!file) return;
    const CameraRoute route = readRoute(*file, {}).value();
    CHECK(route.T_town_camera.size() == drive.frames);
    double length = 0;
    for (std::size_t i = 1; i < drive.frames; ++i) {
      const Eigen::Vector3d step =
          route.T_town_camera[i].translation() - route.T_town_camera[i - 1].translation();
      length += step.norm();
    }
    CHECK(length == Approx(drive.length).margin(1));
    // The car drives forward on level ground: Z is up.
    CHECK(route.T_town_camera[5].translation().y() > 0.3);
    CHECK(std::abs(route.T_town_camera[5].translation().z()) < 0.5);
  }
}

}  // namespace tolman::town::test

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
