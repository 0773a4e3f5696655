// SPDX-License-Identifier: BSD-3-Clause
// Oncoming cars. Their places are functions of the time of the drive.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "route.hpp"
#include "scene.hpp"
#include "shutter_blur.hpp"
#include "street_plan.hpp"
#include "world.hpp"

namespace tolman::town {

/// Cars at equal mean distances on the oncoming lane of the route, each with its own constant
/// speed.
class Traffic {
 public:
  /// Time since the start of the drive, s, and where the camera is then.
  struct Instant {
    double seconds = 0;
    Eigen::Isometry3d T_town_camera = Eigen::Isometry3d::Identity();
  };

  Traffic() = default;
  /// Adds the instances of the cars to `world`, which must contain all other objects. None inside
  /// of buildings.
  Traffic(const CameraRoute& route, const StreetPlan& plan, double cars_per_km, std::uint32_t seed,
          World& world);

  std::size_t size() const { return cars_.size(); }
  Placement at(std::size_t car, const Instant& now) const;
  /// Moves the cars; true if there are some, so that the scene must be committed.
  bool arrange(Scene& scene, const Instant& now) const;
  /// Sets the motion of the cars while a shutter is open.
  void follow(const Instant& begin, const Instant& middle, const Instant& end,
              OpenShutter& shutter) const;

 private:
  struct Car {
    double start;  ///< m along the lane at time 0
    double speed;  ///< m/s against the route's direction
  };
  struct LanePoint {
    Eigen::Vector2d position;
    double s;  ///< m along the lane
  };

  const StreetPlan* plan_ = nullptr;
  std::vector<LanePoint> lane_;  ///< about 1 m apart
  std::vector<Car> cars_;
  std::size_t first_ = 0;  ///< instance of the first car
};

/// The vehicle, moved to the side if it is too near to the camera. On a street that the route takes
/// in both directions the oncoming lane of one pass is the camera's own lane in the other.
Placement besideCamera(Placement vehicle, const Eigen::Isometry3d& T_town_camera);

}  // namespace tolman::town
