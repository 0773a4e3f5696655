// SPDX-License-Identifier: BSD-3-Clause
// Registration of the pose cells.
#include "tolman/plugin.hpp"

#include "pose_cells.hpp"

TOLMAN_PLUGIN(pose_cells, tolman::pose_cells::PoseCells, "0.1.0",
              "RatSLAM's pose cells: a continuous attractor over x, y and heading.");
