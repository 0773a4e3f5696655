// SPDX-License-Identifier: BSD-3-Clause
// The path of the hand-held camera.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hall.hpp"

namespace tolman::town {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kFastest = 0.8;  // m/s

double wave(double phase) { return std::sin(kTurn * phase); }

/// Pose at `angle` (rad) of the ellipse, `seconds` and `metres` after the start.
Eigen::Isometry3d handPose(double angle, double seconds, double metres) {
  const Eigen::Vector2d place(
      Hall::kMiddleX + Hall::kHalfAcross * std::cos(angle) + 0.12 * wave(metres / 5.3),
      Hall::kHalfAlong * std::sin(angle));
  const Eigen::Vector2d along(-Hall::kHalfAcross * std::sin(angle),
                              Hall::kHalfAlong * std::cos(angle));
  const double azimuth = std::atan2(along.x(), along.y()) + 0.35 * wave(seconds / 6.1);
  const double height = 0.25 * wave(metres / 9.4) + 0.015 * wave(1.7 * seconds);
  Eigen::Isometry3d level = Eigen::Isometry3d::Identity();
  // Columns: right, down and forward of the camera in town axes (Z up).
  level.linear() << std::cos(azimuth), 0, std::sin(azimuth), -std::sin(azimuth), 0,
      std::cos(azimuth), 0, -1, 0;
  level.translation() << place, height;
  const double pitch = 0.2 * wave(seconds / 8.3) + 0.01 * wave(1.7 * seconds);
  const double roll = 0.17 * wave(seconds / 4.9);
  level.rotate(Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitX()));
  level.rotate(Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()));
  return level;
}

}  // namespace

CameraRoute hallWalk(const RouteOptions& options) {
  const double step = std::min(options.speed, kFastest) / options.rate;
  CameraRoute route;
  route.building = Building::Hall;
  double angle = 0;
  for (int frame = 0; angle < Hall::kRounds * kTurn; ++frame) {
    const double seconds = frame / options.rate;
    route.stamps_ns.push_back(std::llround(1e9 * seconds));
    route.T_town_camera.push_back(handPose(angle, seconds, frame * step));
    // Constant speed: the step of the angle follows from the derivative of the ellipse.
    angle +=
        step / std::hypot(Hall::kHalfAcross * std::sin(angle), Hall::kHalfAlong * std::cos(angle));
  }
  const double below = options.camera_height + 0.3;
  route.pads.push_back(
      {{Hall::kWest - 2, Hall::kSouth - 2}, {Hall::kEast + 2, Hall::kNorth + 2}, -below});
  return route;
}

CameraRoute streetBesideHall(const CameraRoute& walk) {
  constexpr double kLength = 80;
  constexpr double kAway = 32;
  CameraRoute street = walk;
  const auto frames = static_cast<double>(walk.T_town_camera.size());
  for (std::size_t i = 0; i < walk.T_town_camera.size(); ++i) {
    Eigen::Isometry3d& pose = street.T_town_camera[i];
    pose.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    pose.translation() << kAway, kLength * (static_cast<double>(i) / frames - 0.5), 0;
  }
  return street;
}

}  // namespace tolman::town
