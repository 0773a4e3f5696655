// SPDX-License-Identifier: BSD-3-Clause
// Objects of winter or of another day: bare trees, other parked cars. Each is an additional
// instance at the place of the one that it replaces; one of the two is shown.
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

/// Trees and bushes without leaves, except evergreens.
Exchange addBareTrees(World& world);

/// Other cars at two of three places where one is parked.
Exchange addOtherCars(World& world, std::uint32_t seed);

}  // namespace tolman::town
