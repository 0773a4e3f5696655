// SPDX-License-Identifier: BSD-3-Clause
// Registration of the relaxed experience map.
#include "tolman/plugin.hpp"

#include "relaxation_map.hpp"

TOLMAN_PLUGIN(relaxation, tolman::relaxation::RelaxationMap, "0.1.0",
              "RatSLAM's experience map, corrected by relaxation.");
