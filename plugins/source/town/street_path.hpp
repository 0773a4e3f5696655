// SPDX-License-Identifier: BSD-3-Clause
// The driven path, one point a metre, with the street's centreline beside it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "route.hpp"

namespace tolman::town {

struct PathPoint {
  Eigen::Vector2d driven = Eigen::Vector2d::Zero();      ///< m, town frame, below the camera
  Eigen::Vector2d direction = Eigen::Vector2d::UnitY();  ///< unit vector
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();      ///< m, on the centreline
  double height = 0;        ///< m, Z of the road: camera_height below the camera
  double s = 0;             ///< m driven
  bool driven_over = true;  ///< false where the street goes on beyond either end of the route
  bool raised = false;      ///< on a deck (CameraRoute::raised)
};

/// Standstill and reversing are left out. Before the first pose and after the last one the street
/// goes on for a while, unless the route comes along there itself.
std::vector<PathPoint> samplePath(const CameraRoute& route, double camera_height);

/// Two passes over one street, in either direction: near each other, and not just neighbours on the
/// path. Directions within 35 degrees. Decks are no street.
bool isSameStreet(const PathPoint& a, const PathPoint& b, double reach);

/// Path distance from which near points count as a second pass.
bool isOtherPass(const PathPoint& a, const PathPoint& b);

/// Spatial index of points: finds candidates within kReach of a position.
class PointGrid {
 public:
  static constexpr double kReach = 8;  ///< m

  void add(const Eigen::Vector2d& place, std::size_t index);
  /// In the order of their cells, then of adding; some are farther than kReach.
  std::vector<std::size_t> near(const Eigen::Vector2d& place) const;

 private:
  std::unordered_map<std::int64_t, std::vector<std::size_t>> cells_;
};

}  // namespace tolman::town
