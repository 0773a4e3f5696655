// SPDX-License-Identifier: BSD-3-Clause
// Which frames are on a bridge.
#include "bridges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "street_path.hpp"

namespace tolman::town {
namespace {

constexpr double kCrosses = 4;      ///< m between the centrelines
constexpr double kClearance = 2.5;  ///< m between the roads; with less there is no bridge
constexpr double kReach = 22;       ///< m from the lower centreline to the embankments
constexpr double kBeside = 30;      ///< m of driving within which two passes of one street meet
constexpr double kNear = 5;         ///< m, between passes along one street
const double kLargestBridgeCosine = std::cos(35 * std::numbers::pi / 180);

class BridgeFinder {
 public:
  explicit BridgeFinder(std::vector<PathPoint>& path) : path_(path) {
    for (std::size_t i = 0; i < path.size(); ++i) grid_.add(path[i].driven, i);
  }

  bool find() {
    std::vector<bool> upper(path_.size());
    for (std::size_t i = 0; i < path_.size(); ++i) {
      for (const std::size_t j : grid_.near(path_[i].driven)) {
        if (crossesOver(i, j)) markAround(upper, i, j);
      }
    }
    for (std::size_t i = 0; i < path_.size(); ++i) path_[i].raised = upper[i];
    return std::find(upper.begin(), upper.end(), true) != upper.end();
  }

 private:
  bool crossesOver(std::size_t i, std::size_t j) const {
    const PathPoint& upper = path_[i];
    const PathPoint& lower = path_[j];
    return upper.height - lower.height > kClearance && isOtherPass(upper, lower) &&
           std::abs(upper.direction.dot(lower.direction)) < kLargestBridgeCosine &&
           (upper.centre - lower.centre).norm() < kCrosses && !isOneStreet(i, j);
  }

  /// Whether the passes go along the same street before or after they meet.
  bool isOneStreet(std::size_t i, std::size_t j) const {
    const auto span = static_cast<std::size_t>(kBeside);
    const auto from = [&](std::size_t k) { return k - std::min(k, span); };
    const auto to = [&](std::size_t k) { return std::min(k + span, path_.size() - 1); };
    for (std::size_t a = from(i); a <= to(i); ++a) {
      for (std::size_t b = from(j); b <= to(j); ++b) {
        if (isSameStreet(path_[a], path_[b], kNear)) return true;
      }
    }
    return false;
  }

  /// Marks the upper pass in both directions from the crossing, while the lower street is near.
  void markAround(std::vector<bool>& upper, std::size_t i, std::size_t j) const {
    for (std::size_t k = i; k < path_.size() && isNearLower(k, j); ++k) upper[k] = true;
    for (std::size_t k = i; isNearLower(k, j); --k) {
      upper[k] = true;
      if (k == 0) break;
    }
  }

  bool isNearLower(std::size_t k, std::size_t j) const {
    const auto span = static_cast<std::size_t>(2 * kReach);
    for (std::size_t b = j - std::min(j, span); b <= std::min(j + span, path_.size() - 1); ++b) {
      if ((path_[k].centre - path_[b].centre).norm() < kReach) return true;
    }
    return false;
  }

  std::vector<PathPoint>& path_;
  PointGrid grid_;
};

}  // namespace

CameraRoute bridged(const CameraRoute& route, double camera_height) {
  std::vector<PathPoint> path = samplePath(route, camera_height);
  CameraRoute result = route;
  if (!BridgeFinder(path).find()) return result;
  result.raised.assign(route.T_town_camera.size(), false);
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
    const Eigen::Vector3d& camera = route.T_town_camera[i].translation();
    result.raised[i] = std::any_of(path.begin(), path.end(), [&](const PathPoint& point) {
      return point.raised && (point.driven - camera.head<2>()).norm() < 0.75 &&
             std::abs(point.height + camera_height - camera.z()) < 1;
    });
  }
  return result;
}

}  // namespace tolman::town
