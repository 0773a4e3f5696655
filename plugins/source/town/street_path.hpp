// SPDX-License-Identifier: BSD-3-Clause
// The driven path with one point per metre, and the centreline of its street.
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
  bool driven_over = true;  ///< false for the street beyond either end of the route
  bool raised = false;      ///< on a floor of the car park
};

/// m driven between points of different passes over one street. Chosen, not tuned.
inline constexpr double kOtherPass = 30;

/// Samples the path without standstill and reversing. The street extends beyond the first and the
/// last pose, unless the route passes there itself.
std::vector<PathPoint> samplePath(const CameraRoute& route, double camera_height);

/// Whether two points are of different passes over the same street, in either direction: at most
/// `reach` m apart, not neighbours on the path, directions within 35 degrees. Not in the car park.
bool isSameStreet(const PathPoint& a, const PathPoint& b, double reach);

/// Whether the distance along the path is so large that near points are of two passes.
bool isOtherPass(const PathPoint& a, const PathPoint& b);

/// One metre of centreline.
struct StreetPoint {
  Eigen::Vector2d position;   ///< m, town frame
  Eigen::Vector2d direction;  ///< unit vector, as first driven
  double s = 0;               ///< m along the section
};

/// A stretch of street that was not driven before. A later pass over it, in either direction, is
/// not a new section, so that each place is built once.
struct StreetSection {
  std::vector<StreetPoint> points;
};

/// Sections of at least 6 m in the order of driving, with points 1 m apart.
std::vector<StreetSection> findSections(const std::vector<PathPoint>& path);

/// Spatial index of points: finds candidates within its reach of a position.
class PointGrid {
 public:
  static constexpr double kReach = 8;  ///< m

  explicit PointGrid(double reach = kReach) : reach_(reach) {}
  void add(const Eigen::Vector2d& place, std::size_t index);
  /// Indices of candidates, in the order of their cells, then of insertion. Some are farther.
  std::vector<std::size_t> near(const Eigen::Vector2d& place) const;

 private:
  std::int64_t keyOf(const Eigen::Vector2d& place, int column, int row) const;

  double reach_;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> cells_;
};

}  // namespace tolman::town
