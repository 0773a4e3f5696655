// SPDX-License-Identifier: BSD-3-Clause
// Registers feature_stereo and feature_rgbd.
#include "tolman/plugin.hpp"

#include "feature_stereo.hpp"

using tolman::feature_stereo::FeatureRgbd;
using tolman::feature_stereo::FeatureStereo;

TOLMAN_PLUGIN(feature_stereo, FeatureStereo, "0.1.0",
              "Stereo odometry from tracked corners, robust PnP and a short refined window.");

TOLMAN_PLUGIN(feature_rgbd, FeatureRgbd, "0.1.0",
              "Odometry of one camera with depth images, in metres; otherwise as feature_stereo.");
