// SPDX-License-Identifier: BSD-3-Clause
#include "level_route.hpp"

#include <algorithm>
#include <cmath>

#include "street_grids.hpp"
#include "street_path.hpp"

namespace tolman::town {
namespace {

constexpr double kBendLength = 40;      ///< m
constexpr double kMeetingWeight = 2e4;  ///< so large that passes agree to centimetres
constexpr std::size_t kAhead = 12;      ///< most points of the path between two frames

/// Interpolates the corrections of the path's points at the frames, in the order of the drive.
class Corrections {
 public:
  Corrections(const std::vector<PathPoint>& path, const std::vector<double>& heights)
      : path_(path) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      values_.push_back(heights[i] - path[i].height);
    }
  }

  struct Correction {
    double height;  // m
    double slope;   // m per m driven
  };
  /// To be called for the frames in the order of the drive.
  Correction at(const Eigen::Vector2d& place) {
    const std::size_t end = std::min(at_ + kAhead, path_.size() - 2);
    const std::size_t begin = at_ - std::min(at_, kAhead);
    double nearest = 1e18;
    for (std::size_t i = begin; i <= end; ++i) {
      const double apart = (path_[i].driven - place).squaredNorm();
      if (apart >= nearest) continue;
      nearest = apart;
      at_ = i;
    }
    if (at_ > 0 && along(at_, place) < 0) --at_;
    const double t = std::clamp(along(at_, place), 0.0, 1.0);
    const double step = values_[at_ + 1] - values_[at_];
    const double length = (path_[at_ + 1].driven - path_[at_].driven).norm();
    return {values_[at_] + t * step, length > 0 ? step / length : 0};
  }

 private:
  /// Fraction of the distance from point i to the next one, for a place near it.
  double along(std::size_t i, const Eigen::Vector2d& place) const {
    const Eigen::Vector2d way = path_[i + 1].driven - path_[i].driven;
    return (place - path_[i].driven).dot(way) / std::max(way.squaredNorm(), 1e-9);
  }

  const std::vector<PathPoint>& path_;
  std::vector<double> values_;
  std::size_t at_ = 0;
};

}  // namespace

CameraRoute levelled(const CameraRoute& route, double camera_height) {
  const std::vector<PathPoint> path = samplePath(route, camera_height);
  if (path.size() < 2) return route;
  Corrections corrections(path, agreeOnHeights(path, {kBendLength, kMeetingWeight, true}));
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
