// SPDX-License-Identifier: BSD-3-Clause
// The streets of a route: centrelines, distance to the nearest one, ground height.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "ground_grid.hpp"
#include "route.hpp"
#include "street_path.hpp"
#include "tolman/status.hpp"

namespace tolman::town {

/// Traffic keeps to the right: the centreline is kLaneOffset left of the driven path.
class StreetPlan {
 public:
  static constexpr double kLaneOffset = 1.7;     ///< m, path to centreline
  static constexpr double kRoadHalfWidth = 3.6;  ///< m, centreline to kerb
  static constexpr double kPavementWidth = 2.0;  ///< m
  static constexpr double kKerbHeight = 0.12;    ///< m
  static constexpr double kFarthest = 60;        ///< m; largest value of distance()

  /// Where the heights of passes disagree (in KITTI by up to 1.8 m), the road has their mean, with
  /// a transition to each pass over some 15 m. Streets extend 50 m beyond either end of the route,
  /// unless the route passes there itself.
  ///
  /// Refuses a route for which there are no streets: passes that cross at different heights, a
  /// camera below the ground, an extent beyond 12 km. Messages name the frames.
  /// `groundTrack` of route.hpp makes such routes possible.
  static Result<StreetPlan> grow(const CameraRoute& route, double camera_height);

  const std::vector<StreetSection>& sections() const { return sections_; }
  /// Distance from (x, y) to the nearest centreline, m, at most kFarthest. Continuous.
  double distance(double x, double y) const { return distance_.at(x, y); }
  /// Z of the road or terrain, m, without kerb and pavement. Smooth. At every pose it is
  /// camera_height below the camera, up to the disagreement of passes. Beyond kFarthest it is that
  /// of gentle hills.
  double height(double x, double y) const;
  const Eigen::Vector2d& lowCorner() const { return low_; }
  const Eigen::Vector2d& highCorner() const { return high_; }

 private:
  std::vector<StreetSection> sections_;
  GroundGrid distance_;
  GroundGrid height_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d high_ = Eigen::Vector2d::Zero();
  double mean_height_ = 0;  ///< of the streets
};

}  // namespace tolman::town
