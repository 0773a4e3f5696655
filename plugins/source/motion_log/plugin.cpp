// SPDX-License-Identifier: BSD-3-Clause
// Registration of the motion log.
#include "tolman/plugin.hpp"

#include "motion_log.hpp"

TOLMAN_PLUGIN(motion_log, tolman::motion_log::MotionLog, "0.1.0",
              "Recorded planar motion and loop candidates (g2o files) instead of images.");
