// SPDX-License-Identifier: BSD-3-Clause
// Registration of the replayed odometry.
#include "tolman/plugin.hpp"

#include "motion_replay.hpp"

TOLMAN_PLUGIN(motion_replay, tolman::motion_replay::MotionReplay, "0.1.0",
              "The motion that the source recorded, with noise, bias and losses on demand.");
