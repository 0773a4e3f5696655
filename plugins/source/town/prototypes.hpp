// SPDX-License-Identifier: BSD-3-Clause
// Trees, bushes and cars: each mesh is built once and placed many times.
#pragma once

#include <cstdint>
#include <vector>

#include "world.hpp"

namespace tolman::town {

/// Indices into World::prototypes.
struct Prototypes {
  std::vector<std::uint32_t> street_trees;  ///< slim, with a clear trunk
  std::vector<std::uint32_t> garden_trees;  ///< broad ones and conifers
  std::vector<std::uint32_t> bushes;
  std::vector<std::uint32_t> cars;  ///< facing +X, centred, wheels on Z = 0
};

Prototypes addPrototypes(World& world, std::uint32_t seed);

// The makers, one kind each; each returns the index of its prototype.
std::uint32_t addBroadleaf(World& world, float height, float clear_trunk, std::uint32_t seed);
std::uint32_t addConifer(World& world, float height, std::uint32_t seed);
std::uint32_t addBush(World& world, float size, std::uint32_t seed);

/// Side view of a car: what differs between the kinds.
struct CarShape {
  float length = 4.2F;
  float height = 1.45F;
  float bonnet = 1.05F;  ///< m from the front to the windscreen's foot
  float screen = 0.75F;  ///< m that the windscreen leans back
  float tail = 0.3F;     ///< m that the rear window leans
  float boot = 0.0F;     ///< m of boot behind the rear window
};
std::uint32_t addCar(World& world, const CarShape& shape);

}  // namespace tolman::town
