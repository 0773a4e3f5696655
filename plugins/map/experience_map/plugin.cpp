// SPDX-License-Identifier: BSD-3-Clause
// Registers the experience map.
#include <tolman/plugin.hpp>

#include "experience_map.hpp"

TOLMAN_PLUGIN(
    experience_map, tolman::experience_map::ExperienceMap, "0.1.0",
    "Experience map of the paper, corrected by a robust pose graph, in the plane or in space.");
