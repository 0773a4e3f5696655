// SPDX-License-Identifier: BSD-3-Clause
// Registration of the progress display.
#include "tolman/plugin.hpp"

#include "progress.hpp"

TOLMAN_PLUGIN(progress, tolman::progress::Progress, "0.1.0",
              "Shows frames per second, time left, templates, experiences and loops.");
