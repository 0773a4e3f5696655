// SPDX-License-Identifier: BSD-3-Clause
// Oncoming cars: positions as a function of time.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "lane.hpp"
#include "route.hpp"
#include "street_plan.hpp"
#include "vec3.hpp"

namespace tolman::town {

/// Cars at equal mean distances on the oncoming lane of the route, each with its own constant
/// speed.
class Traffic {
 public:
  Traffic(const CameraRoute& route, const StreetPlan& plan, double cars_per_km, std::uint32_t seed);

  std::size_t size() const { return cars_.size(); }
  /// Place of car `index`, `seconds` after the first pose.
  Placement at(std::size_t index, double seconds) const;

 private:
  struct Car {
    double start;  ///< m along the route at time 0
    double speed;  ///< m/s against the route's direction
  };

  const StreetPlan* plan_;
  Lane lane_;
  std::vector<Car> cars_;
};

/// Upright on the road at a place of a lane, looking along the route or against it.
Placement onRoad(const StreetPlan& plan, const Lane::Position& place, bool comes);

/// Distances that a vehicle keeps from the camera.
struct Clearing {
  double near = 6;    ///< m ahead or behind: a car's length and a half
  double far = 20;    ///< m ahead or behind, where it begins to move aside
  double beside = 3;  ///< m between the centrelines
};

/// The vehicle, moved to the side if it is too near to the camera. On a street that the route takes
/// in both directions the oncoming lane of one pass is the camera's own lane in the other.
Placement besideCamera(Placement vehicle, const Eigen::Isometry3d& T_town_camera,
                       const Clearing& clearing = {});

}  // namespace tolman::town
