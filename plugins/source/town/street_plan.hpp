// SPDX-License-Identifier: BSD-3-Clause
// The streets that grow around a route: centrelines, distance to the nearest one, ground height.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "ground_grid.hpp"
#include "route.hpp"
#include "tolman/status.hpp"

namespace tolman::town {

/// One metre of centreline.
struct StreetPoint {
  Eigen::Vector2d position;   ///< m, town frame
  Eigen::Vector2d direction;  ///< unit vector, as first driven
  double s = 0;               ///< m along the section
};

/// A stretch of street that was not driven before: where a route comes back over an earlier one (in
/// either direction) no new section begins, so that a place is built once.
struct StreetSection {
  std::vector<StreetPoint> points;
};

/// Where the road is above the ground. One point a metre; the centreline.
struct Deck {
  struct Point {
    Eigen::Vector2d position;   ///< m, town frame
    Eigen::Vector2d direction;  ///< unit vector
    double height = 0;          ///< m, Z of the road
  };
  std::vector<Point> points;
};

/// Traffic keeps to the right: the centreline is kLaneOffset left of the driven path.
class StreetPlan {
 public:
  static constexpr double kLaneOffset = 1.7;     ///< m, path to centreline
  static constexpr double kRoadHalfWidth = 3.6;  ///< m, centreline to kerb
  static constexpr double kPavementWidth = 2.0;  ///< m
  static constexpr double kKerbHeight = 0.12;    ///< m
  static constexpr double kFarthest = 60;        ///< m; distance() ends there

  /// Where passes of the route disagree about the height (KITTI's do, by up to 1.8 m), the road
  /// takes the mean and blends into each pass over some 15 m. A street goes on for 50 m beyond
  /// either end of the route, unless the route comes along there itself.
  ///
  /// Raised frames make decks instead of streets.
  ///
  /// Refuses a route that cannot have streets: passes that cross at different heights (a bridge),
  /// a camera that would be under ground, an extent beyond 12 km. Messages name the frames.
  /// `levelled` of level_route.hpp makes most such routes possible.
  static Result<StreetPlan> grow(const CameraRoute& route, double camera_height);

  const std::vector<StreetSection>& sections() const { return sections_; }
  const std::vector<Deck>& decks() const { return decks_; }
  /// m from (x, y) to the nearest point of a deck's centreline; infinite without decks.
  double deckDistance(double x, double y) const;
  /// m from (x, y) to the nearest centreline of any pass, at most kFarthest. Continuous.
  double distance(double x, double y) const { return distance_.at(x, y); }
  /// m, Z of the road surface or of the terrain there, without kerb and pavement. Smooth; under
  /// every pose it is camera_height below the camera, up to what the passes disagree. Beyond
  /// kFarthest it falls back to gentle hills.
  double height(double x, double y) const;
  /// The road below a camera at `camera_z`: that of the highest deck under it, else height().
  double roadHeight(double x, double y, double camera_z) const;
  const Eigen::Vector2d& lowCorner() const { return low_; }
  const Eigen::Vector2d& highCorner() const { return high_; }

 private:
  std::vector<StreetSection> sections_;
  std::vector<Deck> decks_;
  GroundGrid distance_;
  GroundGrid height_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d high_ = Eigen::Vector2d::Zero();
  double mean_height_ = 0;  ///< of the streets
};

}  // namespace tolman::town
