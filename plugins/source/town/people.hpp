// SPDX-License-Identifier: BSD-3-Clause
// Meshes of people and cyclists, facing +X, standing on the origin; one for each posture.
#pragma once

#include <cstdint>
#include <vector>

#include "world.hpp"

namespace tolman::town {

/// Indices into World::prototypes: kGaitPhases postures of a step, then one that stands.
std::vector<std::uint32_t> addWalkers(World& world);

/// kPedalPhases postures of a turn of the pedals.
inline constexpr int kPedalPhases = 4;
std::vector<std::uint32_t> addCyclists(World& world);

}  // namespace tolman::town
