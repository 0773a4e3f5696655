// SPDX-License-Identifier: BSD-3-Clause
// Fills both sides of the streets: chooses the kind of each stretch and places its objects.
#pragma once

#include "prototypes.hpp"
#include "street_plan.hpp"
#include "world.hpp"

namespace tolman::town {

void layOut(World& world, const StreetPlan& plan, const Prototypes& prototypes,
            const WorldOptions& options);

}  // namespace tolman::town
