// SPDX-License-Identifier: BSD-3-Clause
// Bundle adjustment of the active window.
#pragma once

#include "window.hpp"

namespace tolman::feature_stereo {

struct RefinementSettings {
  PixelNoise noise;
  int iterations = 6;
  double offset_sigma = 0.2;  ///< px, prior standard deviation of the disparity offset
  /// px, standard deviation of its change per keyframe; chosen, not tuned
  double offset_drift = 0.01;
};

/// Minimises the reprojection errors over keyframe poses (the oldest is fixed), landmarks and the
/// disparity offset, then removes outlying observations and updates the covariances of landmarks.
/// Single-threaded, with sums in a fixed order: the same window gives the same bits.
void refineWindow(const CameraRig& rig, const RefinementSettings& settings, Window& window);

}  // namespace tolman::feature_stereo
