// SPDX-License-Identifier: BSD-3-Clause
// A path of straight lines and arcs in a lane, written in terms of the streets' centrelines.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace tolman::town {

/// Where and which way the car goes after s metres.
struct LanePosition {
  Eigen::Vector2d position;   ///< m, lane
  Eigen::Vector2d direction;  ///< unit vector
};

/// Lengths and radii are those of centrelines, so that a path closes and comes back on the opposite
/// lane by simple arithmetic; the path itself keeps `lane_offset` to the right. It starts at the
/// origin along Y.
class LanePath {
 public:
  explicit LanePath(double lane_offset) : lane_offset_(lane_offset) {}

  LanePath& ahead(double length);
  /// A bend of the street; a positive angle turns left.
  LanePath& curve(double radius, double angle);
  /// Left, right, left and on along the same line: takes 4 radius sin(angle) of it. A negative
  /// angle begins to the right: the way back.
  LanePath& bulge(double radius, double angle);
  /// 90 degrees at a junction, which counts as no length; radius of the driven arc.
  LanePath& turnLeft(double driven_radius);
  LanePath& turnRight(double driven_radius);
  /// Counter-clockwise round an island in the middle of a junction; leaves `angle` to the left of
  /// the way in (0 straight on, pi back).
  LanePath& roundabout(double driven_radius, double entry_radius, double angle);

  double length() const;
  /// `s` is clamped to the path.
  LanePosition at(double s) const;
  /// 1/m at s, positive to the left.
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
  /// Drives what ahead() promised, short of `kept` metres that a junction takes.
  void flush(double kept);

  double lane_offset_ = 0;
  double ahead_ = 0;  ///< m of street asked for and not yet driven; negative after a junction
  std::vector<Piece> pieces_;
};

}  // namespace tolman::town
