// SPDX-License-Identifier: BSD-3-Clause
// Registration of the hexagonal attractor sheets.
#include "tolman/plugin.hpp"

#include "can_sheet.hpp"

TOLMAN_PLUGIN(can_sheet, tolman::can_sheet::CanSheet, "0.1.0",
              "Hexagonal grid cells: continuous attractors on twisted tori, unit by unit.");
