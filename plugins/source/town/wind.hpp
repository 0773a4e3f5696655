// SPDX-License-Identifier: BSD-3-Clause
// Trees and bushes that sway in the wind. Leaves also move by themselves (ray_packet.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vec3.hpp"
#include "world.hpp"

namespace tolman::town {

class Wind {
 public:
  Wind() = default;
  /// `speed`, m/s, moves the instances of the world that have leaves; 0 none.
  Wind(const World& world, double speed, std::uint32_t seed);

  struct Plant {
    std::size_t instance = 0;
    Placement placement;  ///< in still air
    std::uint32_t seed = 0;
  };
  const std::vector<Plant>& plants() const { return plants_; }
  /// Placement of a plant `seconds` after the first pose.
  Placement at(const Plant& plant, double seconds) const;

 private:
  double speed_ = 0;
  std::uint32_t seed_ = 0;
  std::vector<Plant> plants_;
};

}  // namespace tolman::town
