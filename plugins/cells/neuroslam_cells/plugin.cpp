// SPDX-License-Identifier: BSD-3-Clause
// Registration of NeuroSLAM's cells.
#include "tolman/plugin.hpp"

#include "neuroslam_cells.hpp"

TOLMAN_PLUGIN(neuroslam_cells, tolman::neuroslam_cells::NeuroslamCells, "0.1.0",
              "NeuroSLAM's cells: attractors over heading and height, and over x, y and height.");
