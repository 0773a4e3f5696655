// SPDX-License-Identifier: BSD-3-Clause
// Registers the plugin.
#include "tolman/plugin.hpp"

#include "seqslam.hpp"

using tolman::seqslam::SeqSlam;

TOLMAN_PLUGIN(seqslam, SeqSlam, "0.1.0",
              "SeqSLAM (Milford and Wyeth 2012): the last images along lines of constant speed.");
