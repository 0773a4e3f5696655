// SPDX-License-Identifier: BSD-3-Clause
// Routes made of others: flights, the ground below them, passes that agree on heights.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ground_grid.hpp"
#include "route.hpp"

namespace tolman::town {
namespace {

constexpr double kBendLength = 40;      ///< m
constexpr double kMeetingWeight = 2e4;  ///< so large that passes agree to centimetres
constexpr std::size_t kAhead = 12;      ///< most points of the path between two frames

/// Interpolates the corrections of the path's points at the frames, in the order of the drive.
class Corrections {
 public:
  Corrections(const std::vector<PathPoint>& path, const std::vector<double>& heights)
      : path_(path), heights_(heights) {}

  struct Correction {
    double height;  // m
    double slope;   // m per m driven
  };
  /// To be called for the frames in the order of the drive.
  Correction at(const Eigen::Vector2d& place) {
    const std::size_t end = std::min(at_ + kAhead, path_.size() - 2);
    double nearest = 1e18;
    for (std::size_t i = at_ - std::min(at_, kAhead); i <= end; ++i) {
      const double apart = (path_[i].driven - place).squaredNorm();
      if (apart >= nearest) continue;
      nearest = apart;
      at_ = i;
    }
    if (at_ > 0 && along(at_, place) < 0) --at_;
    const double t = std::clamp(along(at_, place), 0.0, 1.0);
    const double here = heights_[at_] - path_[at_].height;
    const double step = heights_[at_ + 1] - path_[at_ + 1].height - here;
    const double length = (path_[at_ + 1].driven - path_[at_].driven).norm();
    return {here + t * step, length > 0 ? step / length : 0};
  }

 private:
  /// Fraction of the distance from point i to the next one, for a place near it.
  double along(std::size_t i, const Eigen::Vector2d& place) const {
    const Eigen::Vector2d way = path_[i + 1].driven - path_[i].driven;
    return (place - path_[i].driven).dot(way) / std::max(way.squaredNorm(), 1e-9);
  }

  const std::vector<PathPoint>& path_;
  const std::vector<double>& heights_;
  std::size_t at_ = 0;
};

}  // namespace

Eigen::Isometry3d levelPose(double azimuth) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  // Columns: right, down and forward of the camera in town axes (Z up).
  pose.linear() << std::cos(azimuth), 0, std::sin(azimuth), -std::sin(azimuth), 0,
      std::cos(azimuth), 0, -1, 0;
  return pose;
}

CameraRoute groundTrack(const CameraRoute& flown) {
  CameraRoute track = flown;
  for (Eigen::Isometry3d& pose : track.T_town_camera) {
    const Eigen::Vector3d ahead = pose.linear().col(2);
    const double azimuth = ahead.head<2>().norm() > 1e-6 ? std::atan2(ahead.x(), ahead.y()) : 0;
    pose.linear() = levelPose(azimuth).linear();
    pose.translation().z() = flown.T_town_camera.front().translation().z();
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

CameraRoute levelled(const CameraRoute& route, double camera_height) {
  const std::vector<PathPoint> path = samplePath(route, camera_height);
  if (path.size() < 2) return route;
  const std::vector<double> heights = agreeOnHeights(path, {kBendLength, kMeetingWeight, true});
  Corrections corrections(path, heights);
  CameraRoute level = route;
  for (Eigen::Isometry3d& T_town_camera : level.T_town_camera) {
    const auto [height, slope] = corrections.at(T_town_camera.translation().head<2>());
    T_town_camera.translation().z() += height;
    const Eigen::AngleAxisd upwards(std::atan(slope), Eigen::Vector3d::UnitX());
    T_town_camera.linear() = T_town_camera.linear() * upwards.toRotationMatrix();
  }
  return level;
}

}  // namespace tolman::town
