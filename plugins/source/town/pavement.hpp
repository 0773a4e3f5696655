// SPDX-License-Identifier: BSD-3-Clause
// Where people walk: stretches of pavement between side streets, round parked cars.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "street_plan.hpp"

namespace tolman::town {

/// One point a metre.
struct PavementRun {
  std::vector<Eigen::Vector2d> points;  ///< m, town frame
  bool is_left = false;                 ///< of the street as first driven: the road is to the right

  double length() const;
  struct Place {
    Eigen::Vector2d position;
    Eigen::Vector2d along;  ///< unit vector
  };
  /// `s` within [0, length()].
  Place at(double s) const;
};

/// Both sides of all streets, without runs too short to walk along. `cars` are the places of parked
/// ones, which stand on half of the pavement.
std::vector<PavementRun> pavementRuns(const StreetPlan& plan,
                                      const std::vector<Eigen::Vector2d>& cars);

}  // namespace tolman::town
