// SPDX-License-Identifier: BSD-3-Clause
// Ground plans of objects, and a register that keeps them from overlapping.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "street_plan.hpp"

namespace tolman::town {

/// A rectangle on the ground.
struct Plot {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  ///< unit vector of its length
  double half_length = 1;                           ///< m, along axis
  double half_depth = 1;                            ///< m, across

  Eigen::Vector2d across() const { return {-axis.y(), axis.x()}; }
  Eigen::Vector2d point(double along, double over) const {
    return centre + axis * along + across() * over;
  }
};

bool overlap(const Plot& a, const Plot& b);

class PlotBook {
 public:
  explicit PlotBook(const StreetPlan& plan) : plan_(&plan) {}

  /// Registers the plot if it is free and at least `clearance` m from every centreline. Its half
  /// dimensions must be below 35 m.
  bool enter(const Plot& plot, double clearance);

 private:
  bool clearOfStreets(const Plot& plot, double clearance) const;

  const StreetPlan* plan_;
  std::unordered_map<std::int64_t, std::vector<Plot>> cells_;
};

}  // namespace tolman::town
