// SPDX-License-Identifier: BSD-3-Clause
// The paths of people: stretches of pavement between side streets, round parked cars.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "street_plan.hpp"

namespace tolman::town {

/// A path with one point per metre.
struct PavementRun {
  std::vector<Eigen::Vector2d> points;  ///< m, town frame
  bool is_left = false;  ///< on the left of the street as first driven, so the road is on the right

  double length() const;
  struct Position {
    Eigen::Vector2d position;
    Eigen::Vector2d along;  ///< unit vector
  };
  /// `s` within [0, length()].
  Position at(double s) const;
};

/// The paths on both sides of all streets, without very short ones. `cars`: places of parked cars,
/// which cover half of the pavement.
std::vector<PavementRun> pavementRuns(const StreetPlan& plan,
                                      const std::vector<Eigen::Vector2d>& cars);

}  // namespace tolman::town
