// SPDX-License-Identifier: BSD-3-Clause
// Street furniture (lamps, signs, posters, fences, hedges) and lane markings.
#pragma once

#include <cstdint>

#include "plots.hpp"
#include "street_plan.hpp"
#include "world.hpp"

namespace tolman::town {

/// Place and orientation of an object beside the street.
struct Stand {
  Vec3 foot;
  Vec3 along;   ///< unit vector of the street
  Vec3 inward;  ///< unit vector towards the middle of the street
  std::uint32_t seed = 0;
};

void addLamp(World& world, const Stand& stand);
void addSign(World& world, const Stand& stand);
void addPoster(World& world, const Stand& stand);

/// A fence or a hedge over the plot's length; `hedge` is as deep as the plot.
void addFence(World& world, const Plot& plot, double ground, std::uint32_t seed);
void addHedge(World& world, const Plot& plot, double ground, std::uint32_t seed);

/// The broken line in the middle of each section, without junctions.
void addLaneMarkings(World& world, const StreetPlan& plan, std::uint32_t seed);

/// Identical rails on posts on both sides of the streets, without junctions.
void addGuardRails(World& world, const StreetPlan& plan);

/// A ring of wooded hills that closes the view.
void addHorizon(World& world, const StreetPlan& plan, std::uint32_t seed);

}  // namespace tolman::town
