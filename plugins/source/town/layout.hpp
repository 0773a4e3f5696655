// SPDX-License-Identifier: BSD-3-Clause
// Fills both sides of the streets: what kind of place each stretch is, and what stands where.
#pragma once

#include "prototypes.hpp"
#include "street_plan.hpp"
#include "world.hpp"

namespace tolman::town {

void layOut(World& world, const StreetPlan& plan, const Prototypes& prototypes,
            const WorldOptions& options);

}  // namespace tolman::town
