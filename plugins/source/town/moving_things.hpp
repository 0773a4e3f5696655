// SPDX-License-Identifier: BSD-3-Clause
// Moving objects of the town: cars, cyclists, people, trees in the wind. Their places are functions
// of the time of the drive.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "crossing_traffic.hpp"
#include "cyclists.hpp"
#include "light.hpp"
#include "pedestrians.hpp"
#include "pixel_paths.hpp"
#include "scene.hpp"
#include "town_parameters.hpp"
#include "traffic.hpp"
#include "wind.hpp"
#include "world.hpp"

namespace tolman::town {

class MovingThings {
 public:
  /// Time since the start of the drive, s, and where the camera is then.
  struct Instant {
    double seconds = 0;
    Eigen::Isometry3d T_town_camera = Eigen::Isometry3d::Identity();
  };

  /// Adds their instances to `world`, which must contain all other objects.
  MovingThings(const TownParameters& parameters, const CameraRoute& route, const StreetPlan& plan,
               World& world);

  /// Moves the objects; true if some have moved, so that the scene must be committed.
  bool arrange(Scene& scene, const Instant& now);
  /// Sets the motion of vehicles and people while a shutter is open; after arrange() for the middle
  /// of this time. Trees count as fixed, because they sway by less than a millimetre.
  void follow(const Instant& begin, const Instant& end, OpenShutter& shutter) const;
  /// Adds the lamps of moving cars near the camera if `traffic_headlights` is set; after arrange().
  void addHeadlights(Light& light, const Eigen::Isometry3d& T_town_camera) const;

 private:
  MovingThings(const TownParameters& parameters, const StreetPlan& plan, World& world,
               const CameraRoute& route);
  struct Pose {
    std::optional<Placement> placement;      ///< none if it is not shown
    std::optional<std::uint32_t> prototype;  ///< of its posture, if it has several
  };
  /// Of traffic, crossing cars, cyclists and people, in the order of their instances.
  std::vector<Pose> posesAt(const Instant& now) const;

  bool headlights_;
  Traffic traffic_;
  CrossingTraffic crossing_;
  Cyclists cyclists_;
  std::optional<Pedestrians> pedestrians_;
  Wind wind_;
  std::size_t first_ = 0;               ///< instance: traffic, then crossing cars, cyclists, people
  std::vector<std::uint32_t> walkers_;  ///< prototypes of postures
  std::vector<std::uint32_t> pedals_;
  std::vector<Pose> arranged_;  ///< by the last arrange()
};

}  // namespace tolman::town
