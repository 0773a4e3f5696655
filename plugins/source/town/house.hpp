// SPDX-License-Identifier: BSD-3-Clause
// One house: walls with facades, a roof, chimneys.
#pragma once

#include "plots.hpp"
#include "tolman/context.hpp"
#include "world.hpp"

namespace tolman::town {

enum class RoofShape : std::uint8_t { AlongStreet, ToStreet, Flat };

struct House {
  Plot plot;          ///< its ground plan; `axis` is parallel to the street
  double ground = 0;  ///< m, Z of the land at its centre
  int storeys = 2;
  RoofShape roof = RoofShape::AlongStreet;
  std::uint32_t seed = 0;
};

void addHouse(World& world, const House& house);

}  // namespace tolman::town
