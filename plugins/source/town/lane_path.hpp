// SPDX-License-Identifier: BSD-3-Clause
// A path of straight lines and arcs in a lane, written in terms of the streets' centrelines.
#pragma once

#include <Eigen/Core>
#include <numbers>
#include <vector>

namespace tolman::town {

inline constexpr double kPi = std::numbers::pi;

/// Position and direction of the car after s metres.
struct LanePosition {
  Eigen::Vector2d position;   ///< m, lane
  Eigen::Vector2d direction;  ///< unit vector
};

/// Lengths and radii are those of centrelines, so that closed paths and ways back on the opposite
/// lane are easy to compute. The path itself is `lane_offset` m to the right. It starts at the
/// origin along Y.
class LanePath {
 public:
  explicit LanePath(double lane_offset) : lane_offset_(lane_offset) {}

  LanePath& ahead(double length);
  /// A bend of the street; a positive angle turns left.
  LanePath& curve(double radius, double angle);
  /// Three bends, left, right, left, that end on the same line after 4 radius sin(angle). A
  /// negative angle begins to the right, for the way back.
  LanePath& bulge(double radius, double angle);
  /// A turn of 90 degrees at a junction, whose length is not counted. `driven_radius`: of the path,
  /// m.
  LanePath& turnLeft(double driven_radius);
  LanePath& turnRight(double driven_radius);
  /// Counter-clockwise round an island in the middle of a junction; the exit is `angle` rad to the
  /// left of the entry direction (0 straight on, pi back).
  LanePath& roundabout(double driven_radius, double entry_radius, double angle);

  double length() const;
  /// `s` is clamped to the path.
  LanePosition at(double s) const;
  /// Curvature at s, 1/m, positive to the left.
  double curvature(double s) const;

 private:
  struct Piece {
    double start_s = 0;
    double length = 0;
    double curvature = 0;
    Eigen::Vector2d position;
    double heading = 0;  ///< radians from X, counter-clockwise
  };

  const Piece& pieceAt(double s) const;
  void turn(double driven_radius, double angle, double along_street);
  void add(double length, double curvature);
  /// Adds the straight line that ahead() has accumulated, without the last `kept` metres, which
  /// belong to a junction.
  void flush(double kept);

  double lane_offset_ = 0;
  double ahead_ = 0;  ///< m of street not yet added as a piece; negative after a junction
  std::vector<Piece> pieces_;
};

}  // namespace tolman::town
