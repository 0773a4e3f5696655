// SPDX-License-Identifier: BSD-3-Clause
// Registers scanline.
#include "tolman/plugin.hpp"

#include "scanline.hpp"

TOLMAN_PLUGIN(scanline, tolman::scanline::Scanline, "0.1.0",
              "Rough odometry of one camera from its column intensities, as RatSLAM has it.");
