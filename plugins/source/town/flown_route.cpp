// SPDX-License-Identifier: BSD-3-Clause
#include "flown_route.hpp"

#include <cmath>
#include <numbers>

namespace tolman::town {

CameraRoute groundTrack(const CameraRoute& flown) {
  CameraRoute track = flown;
  for (Eigen::Isometry3d& pose : track.T_town_camera) {
    const Eigen::Vector3d ahead = pose.linear().col(2);
    const double azimuth = ahead.head<2>().norm() > 1e-6 ? std::atan2(ahead.x(), ahead.y()) : 0;
    // Columns: right, down and forward of the camera in town axes (Z up).
    pose.linear() << std::cos(azimuth), 0, std::sin(azimuth), -std::sin(azimuth), 0,
        std::cos(azimuth), 0, -1, 0;
    pose.translation().z() = flown.T_town_camera.front().translation().z();
  }
  return track;
}

CameraRoute flown(const CameraRoute& driven) {
  constexpr double kTurn = 2 * std::numbers::pi;
  constexpr double kAmplitude = 8 * std::numbers::pi / 180;
  const auto seconds = [&](std::size_t i) {
    return 1e-9 * static_cast<double>(driven.stamps_ns[i] - driven.stamps_ns[0]);
  };
  CameraRoute route = groundTrack(driven);
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
    Eigen::Isometry3d& pose = route.T_town_camera[i];
    const Eigen::Vector3d place = pose.translation() - route.T_town_camera[0].translation();
    pose.translation().z() +=
        2 - std::cos(kTurn * place.x() / 110) - std::cos(kTurn * place.y() / 90);
    pose.rotate(Eigen::AngleAxisd(kAmplitude * std::sin(kTurn * seconds(i) / 7.3),
                                  Eigen::Vector3d::UnitX()));
    pose.rotate(Eigen::AngleAxisd(kAmplitude * std::sin(kTurn * seconds(i) / 5.1),
                                  Eigen::Vector3d::UnitZ()));
  }
  return route;
}

}  // namespace tolman::town
