// SPDX-License-Identifier: BSD-3-Clause
// Routes without a file: their streets, the height of the ground, and the speed in bends.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "buildings.hpp"
#include "lane_path.hpp"
#include "route.hpp"
#include "street_plan.hpp"

namespace tolman::town {
namespace {

constexpr double kLateralAcceleration = 1.5;       ///< m/s^2, in bends
constexpr double kLongitudinalAcceleration = 1.5;  ///< m/s^2, before and after them
constexpr double kSpeedStep = 0.05;                ///< m

/// Once round a block, then 30 m beyond the start.
LanePath blockPath() {
  LanePath path(StreetPlan::kLaneOffset);
  path.ahead(40).turnRight(7);
  path.ahead(65).turnRight(7);
  path.ahead(20).bulge(30, 0.28).ahead(48 - 4 * 30 * std::sin(0.28) + 12).turnRight(7);
  path.ahead(65).turnRight(7);
  path.ahead(40 + 30);
  return path;
}

/// Two blocks that meet at one corner: over the crossing, right round the one, straight over the
/// crossing again, left round the other; all of it twice.
LanePath eightsPath() {
  LanePath path(StreetPlan::kLaneOffset);
  path.ahead(25);
  for (int round = 0; round < 2; ++round) {
    path.ahead(46).turnRight(7);
    path.ahead(55).turnRight(6);
    path.ahead(46).turnRight(7);
    path.ahead(55).ahead(50).turnLeft(9);
    path.ahead(40).turnLeft(10);
    path.ahead(50).turnLeft(9);
    path.ahead(40);
  }
  path.ahead(15);
  return path;
}

/// A block of 80 m x 90 m and one of 80 m x 65 m north of it, with a roundabout at their far
/// corner: round the first, back over the start, to the roundabout and back on the other lane,
/// round the second, over the roundabout again, and the first block the other way round.
LanePath districtPath() {
  constexpr double kBend = 0.22;
  const double bend = 4 * 40 * std::sin(kBend);
  const double roundabout_radius = 11;
  LanePath path(StreetPlan::kLaneOffset);
  path.ahead(45).turnRight(7);
  path.ahead(80).turnRight(7);
  path.ahead(25).bulge(40, kBend).ahead(65 - bend).turnRight(6);
  path.ahead(80).turnRight(7);
  path.ahead(45 + 45 + 65).roundabout(roundabout_radius, 10, kPi);
  path.ahead(65).turnLeft(9);
  path.ahead(80).turnLeft(9);
  path.ahead(65).turnLeft(9);
  path.ahead(80).roundabout(roundabout_radius, 10, kPi / 2);
  path.ahead(65 + 45 + 45).turnLeft(9);
  path.ahead(80).turnLeft(9);
  path.ahead(65 - bend).bulge(40, -kBend).ahead(3);
  return path;
}

/// 1.3 km with two wide bends.
LanePath highwayPath() {
  constexpr double kBend = 0.2;
  LanePath path(StreetPlan::kLaneOffset);
  path.ahead(350).bulge(400, kBend).ahead(250).bulge(500, -kBend).ahead(100);
  return path;
}

/// Height of the streets above the start, m, and its slope, which is 0 at the start and always
/// below 5 %.
struct Ground {
  double height = 0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
};

Ground groundAt(const Eigen::Vector2d& place) {
  struct Wave {
    double amplitude;   // m
    double wavelength;  // m
    double azimuth;     // radians
  };
  static constexpr std::array<Wave, 3> kWaves = {
      {{1.0, 400, 1.2}, {-0.6, 260, 0.3}, {0.4, 190, 2.3}}};
  Ground ground;
  for (const Wave& wave : kWaves) {
    const Eigen::Vector2d k =
        2 * kPi / wave.wavelength * Eigen::Vector2d(std::cos(wave.azimuth), std::sin(wave.azimuth));
    const double phase = k.dot(place);
    ground.height += wave.amplitude * (1 - std::cos(phase));
    ground.gradient += wave.amplitude * std::sin(phase) * k;
  }
  return ground;
}

Eigen::Isometry3d cameraPose(const LanePosition& lane, double height, double slope) {
  const Eigen::Vector2d left(-lane.direction.y(), lane.direction.x());
  const Eigen::Vector3d forward =
      Eigen::Vector3d(lane.direction.x(), lane.direction.y(), slope).normalized();
  const Eigen::Vector3d right(-left.x(), -left.y(), 0);
  Eigen::Isometry3d T_town_camera = Eigen::Isometry3d::Identity();
  T_town_camera.linear() << right, forward.cross(right), forward;
  T_town_camera.translation() << lane.position, height;
  return T_town_camera;
}

/// Pose on the ground. Streets are level across: both lanes have the height and slope of the
/// centreline.
Eigen::Isometry3d poseOnGround(const LanePosition& lane) {
  const Eigen::Vector2d left(-lane.direction.y(), lane.direction.x());
  const Eigen::Vector2d start_centre(-StreetPlan::kLaneOffset, 0);
  const Ground ground = groundAt(lane.position + StreetPlan::kLaneOffset * left - start_centre);
  return cameraPose(lane, ground.height, ground.gradient.dot(lane.direction));
}

/// v^2 (m^2/s^2) every kSpeedStep: limited in bends, then by acceleration (in a forward sweep) and
/// by braking (in a backward sweep).
std::vector<double> squaredSpeeds(const LanePath& path, double speed) {
  const auto steps = static_cast<std::size_t>(std::ceil(path.length() / kSpeedStep));
  std::vector<double> squared(steps + 1, speed * speed);
  for (std::size_t i = 0; i <= steps; ++i) {
    for (const double side : {-0.5, 0.5}) {  // steps with an end of a bend belong to it
      const double s = (static_cast<double>(i) + side) * kSpeedStep;
      const double curvature = std::abs(path.curvature(s));
      if (curvature > 0) squared[i] = std::min(squared[i], kLateralAcceleration / curvature);
    }
  }
  squared.front() = std::min(squared.front(), speed * speed / 4);
  squared.back() = std::min(squared.back(), speed * speed / 4);
  const double gain = 2 * kLongitudinalAcceleration * kSpeedStep;
  for (std::size_t i = 1; i <= steps; ++i) squared[i] = std::min(squared[i], squared[i - 1] + gain);
  for (std::size_t i = steps; i-- > 0;) squared[i] = std::min(squared[i], squared[i + 1] + gain);
  return squared;
}

/// Distance s, m, at every frame, with constant acceleration within a step.
std::vector<double> frameDistances(const LanePath& path, const RouteOptions& options) {
  const std::vector<double> squared = squaredSpeeds(path, options.speed);
  std::vector<double> distances;
  double start_time = 0;
  for (std::size_t i = 0; i + 1 < squared.size(); ++i) {
    const double v = std::sqrt(squared[i]);
    const double duration = 2 * kSpeedStep / (v + std::sqrt(squared[i + 1]));
    const double acceleration = (squared[i + 1] - squared[i]) / (2 * kSpeedStep);
    for (;;) {
      const double t = static_cast<double>(distances.size()) / options.rate - start_time;
      if (t >= duration) break;
      const double s = static_cast<double>(i) * kSpeedStep + v * t + acceleration * t * t / 2;
      if (s > path.length()) return distances;
      distances.push_back(s);
    }
    start_time += duration;
  }
  return distances;
}

CameraRoute carParkRoute(RouteOptions options) {
  constexpr double kFastest = 5;      // m/s
  constexpr double kPadBelow = 0.35;  // m, under the lowest floor
  constexpr double kLevelGround = 3;  // m of level ground around the building
  options.speed = std::min(options.speed, kFastest);
  const CarParkDrive drive = carParkDrive();
  CameraRoute route;
  route.building = Building::CarPark;
  for (const double s : frameDistances(drive.path, options)) {
    const auto [height, slope] = drive.at(s);
    route.add(cameraPose(drive.path.at(s), height, slope), options.rate);
    route.raised.push_back(s > drive.inside_from && s < drive.inside_to);
  }
  route.pads.push_back(
      {{CarPark::kWest - kLevelGround, CarPark::kAisleY + CarPark::kSouth - kLevelGround},
       {CarPark::kEast + kLevelGround, CarPark::kAisleY + CarPark::kNorth + kLevelGround},
       -options.camera_height - kPadBelow});
  return route;
}

}  // namespace

Result<CameraRoute> builtInRoute(std::string_view name, const RouteOptions& options) {
  CameraRoute route;
  const auto along = [&](const LanePath& path) {
    for (const double s : frameDistances(path, options)) {
      route.add(poseOnGround(path.at(s)), options.rate);
    }
  };
  if (name == "block") {
    along(blockPath());
  } else if (name == "eights") {
    along(eightsPath());
  } else if (name == "district") {
    along(districtPath());
  } else if (name == "highway") {
    along(highwayPath());
    route.is_highway = true;
  } else if (name == "car_park") {
    route = carParkRoute(options);
  } else if (name == "hall") {
    route = hallWalk(options);
  } else {
    return Status::invalidParameter(
        "there is no route '" + std::string(name) +
        "'; use block, eights, district, highway, car_park, hall, or a KITTI pose file");
  }
  route.name = name;
  return route;
}

}  // namespace tolman::town
