// SPDX-License-Identifier: BSD-3-Clause
// What stands in the town in winter or on another day: bare trees, other parked cars. Each stands
// beside what it replaces, and one of the two is shown.
#pragma once

#include <cstddef>
#include <vector>

#include "world.hpp"

namespace tolman::town {

/// Indices of instances.
struct Exchange {
  std::vector<std::size_t> usual;
  std::vector<std::size_t> other;
};

/// Trees and bushes without leaves; evergreens keep theirs.
Exchange addBareTrees(World& world);

/// Other cars at two of three places where one is parked.
Exchange addOtherCars(World& world, std::uint32_t seed);

}  // namespace tolman::town
