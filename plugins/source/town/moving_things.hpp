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
#include "scene.hpp"
#include "town_parameters.hpp"
#include "traffic.hpp"
#include "wind.hpp"
#include "world.hpp"

namespace tolman::town {

class MovingThings {
 public:
  /// Adds their instances to `world`, which must contain all other objects.
  MovingThings(const TownParameters& parameters, const CameraRoute& route, const StreetPlan& plan,
               World& world);

  /// Moves the objects; true if some have moved, so that the scene must be committed.
  bool arrange(Scene& scene, double seconds, const Eigen::Isometry3d& T_town_camera);
  /// Adds the lamps of moving cars near the camera if `traffic_headlights` is set; after arrange().
  void addHeadlights(Light& light, const Eigen::Isometry3d& T_town_camera) const;

 private:
  MovingThings(const TownParameters& parameters, const StreetPlan& plan, World& world,
               const CameraRoute& route);
  void arrangeCars(Scene& scene, double seconds, const Eigen::Isometry3d& T_town_camera);
  void arrangePeople(Scene& scene, double seconds, const Eigen::Isometry3d& T_town_camera);

  bool headlights_;
  Traffic traffic_;
  CrossingTraffic crossing_;
  Cyclists cyclists_;
  std::optional<Pedestrians> pedestrians_;
  Wind wind_;
  std::size_t first_car_ = 0;  ///< instances: traffic, then crossing cars
  std::size_t first_cyclist_ = 0;
  std::size_t first_pedestrian_ = 0;
  std::vector<std::uint32_t> walkers_;  ///< prototypes of postures
  std::vector<std::uint32_t> pedals_;
  std::vector<Placement> cars_;  ///< places of the cars that are shown
};

}  // namespace tolman::town
