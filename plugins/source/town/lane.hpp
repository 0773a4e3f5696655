// SPDX-License-Identifier: BSD-3-Clause
// A line beside the route that other vehicles drive along.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "route.hpp"

namespace tolman::town {

class Lane {
 public:
  struct Position {
    Eigen::Vector2d position;  ///< m, town frame
    Eigen::Vector2d along;     ///< in the direction of the route, of any length
    double camera_z = 0;       ///< m, of the camera beside it
  };

  Lane() = default;
  /// `left` m to the left of the camera; negative to the right.
  Lane(const CameraRoute& route, double left);

  bool isEmpty() const { return points_.size() < 2; }
  /// Length, m.
  double length() const { return points_.empty() ? 0 : points_.back().s; }
  /// `s`, m, must be within [0, length()], and the lane not empty.
  Position at(double s) const;
  /// Frame of the route at the point at s.
  std::size_t frameAt(double s) const;

 private:
  struct Point {
    Eigen::Vector2d position;
    double s;
    std::size_t frame;
    double camera_z;
  };
  std::size_t after(double s) const;

  std::vector<Point> points_;  ///< about 1 m apart, with increasing s
};

}  // namespace tolman::town
