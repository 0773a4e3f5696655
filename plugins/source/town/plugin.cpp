// SPDX-License-Identifier: BSD-3-Clause
// Registration of the town.
#include "tolman/plugin.hpp"

#include "town_source.hpp"

TOLMAN_PLUGIN(town, tolman::town::TownSource, "0.1.0",
              "A procedural town, driven and rendered as calibrated stereo with exact truth.");
