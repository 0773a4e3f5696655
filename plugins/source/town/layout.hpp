// SPDX-License-Identifier: BSD-3-Clause
// Chooses the kind of each stretch on both sides of the streets and places its objects.
#pragma once

#include "prototypes.hpp"
#include "street_plan.hpp"
#include "world.hpp"

namespace tolman::town {

void layOut(World& world, const StreetPlan& plan, const Prototypes& prototypes,
            const WorldOptions& options);

}  // namespace tolman::town
