// SPDX-License-Identifier: BSD-3-Clause
// Routes made of others: flights, and the level ground below them.
#include <cmath>
#include <numbers>

#include "route.hpp"

namespace tolman::town {
Eigen::Isometry3d levelPose(double azimuth) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  // Columns: right, down and forward of the camera in town axes (Z up).
  pose.linear() << std::cos(azimuth), 0, std::sin(azimuth), -std::sin(azimuth), 0,
      std::cos(azimuth), 0, -1, 0;
  return pose;
}

CameraRoute groundTrack(const CameraRoute& route) {
  CameraRoute track = route;
  for (Eigen::Isometry3d& pose : track.T_town_camera) {
    const Eigen::Vector3d ahead = pose.linear().col(2);
    const double azimuth = ahead.head<2>().norm() > 1e-6 ? std::atan2(ahead.x(), ahead.y()) : 0;
    pose.linear() = levelPose(azimuth).linear();
    pose.translation().z() = route.T_town_camera.front().translation().z();
  }
  return track;
}

CameraRoute flown(const CameraRoute& driven) {
  constexpr double kTurn = 2 * std::numbers::pi;
  constexpr double kAmplitude = 8 * std::numbers::pi / 180;
  CameraRoute route = groundTrack(driven);
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
    Eigen::Isometry3d& pose = route.T_town_camera[i];
    const double seconds = 1e-9 * static_cast<double>(driven.stamps_ns[i] - driven.stamps_ns[0]);
    const Eigen::Vector3d place = pose.translation() - route.T_town_camera[0].translation();
    pose.translation().z() +=
        2 - std::cos(kTurn * place.x() / 110) - std::cos(kTurn * place.y() / 90);
    pose.rotate(
        Eigen::AngleAxisd(kAmplitude * std::sin(kTurn * seconds / 7.3), Eigen::Vector3d::UnitX()));
    pose.rotate(
        Eigen::AngleAxisd(kAmplitude * std::sin(kTurn * seconds / 5.1), Eigen::Vector3d::UnitZ()));
  }
  return route;
}

}  // namespace tolman::town
