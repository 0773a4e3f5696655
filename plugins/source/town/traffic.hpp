// SPDX-License-Identifier: BSD-3-Clause
// Oncoming cars: positions as a function of time.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "route.hpp"
#include "street_plan.hpp"
#include "vec3.hpp"

namespace tolman::town {

/// Cars at equal mean distances on the oncoming lane of the route, each at its own steady speed.
class Traffic {
 public:
  Traffic(const CameraRoute& route, const StreetPlan& plan, double cars_per_km, std::uint32_t seed);

  std::size_t size() const { return cars_.size(); }
  /// Where car `index` is, `seconds` after the first pose.
  Placement at(std::size_t index, double seconds) const;

 private:
  struct Car {
    double start;  ///< m along the route at time 0
    double speed;  ///< m/s against the route's direction
  };
  struct LanePoint {
    Eigen::Vector2d position;
    double s;
  };

  const StreetPlan* plan_;
  std::vector<LanePoint> lane_;  ///< the oncoming lane, s growing
  std::vector<Car> cars_;
};

/// The car, moved to the side where it would come too near to the camera. On a street that the
/// route takes in both directions the oncoming lane of one pass is the camera's own in the other.
Placement besideCamera(Placement car, const Eigen::Isometry3d& T_town_camera);

}  // namespace tolman::town
