// SPDX-License-Identifier: BSD-3-Clause
// Registers feature_stereo.
#include "tolman/plugin.hpp"

#include "feature_stereo.hpp"

using tolman::feature_stereo::FeatureStereo;

TOLMAN_PLUGIN(feature_stereo, FeatureStereo, "0.1.0",
              "Stereo odometry from tracked corners, robust PnP and a short refined window.");
