// SPDX-License-Identifier: BSD-3-Clause
// Windowed photometric bundle adjustment (paper, joint optimisation): Gauss-Newton over poses,
// brightness, inverse depths and the disparity offset.
#pragma once

#include "linear_system.hpp"

namespace tolman::direct_sparse {

struct AdjustmentSettings {
  SystemSettings system;
  int iterations = 4;
  Scale scale = Scale::Known;
};

struct AdjustmentResult {
  int iterations = 0;
  double energy = 0;  ///< before the last step
  int residuals = 0;
  double metres = 0;   ///< farthest that a keyframe went from where it was, as the oldest sees it
  double radians = 0;  ///< and the most that one turned
};

/// `system` is working memory. Residual states and informations of the points are up to date with
/// the state before the last, small step.
AdjustmentResult adjustWindow(const CameraRig& rig, const AdjustmentSettings& settings,
                              Window& window, LinearSystem& system);

/// Gives up residuals that ended as outliers or outside, and points without any residual left.
void dropOutliers(Window& window);

}  // namespace tolman::direct_sparse
