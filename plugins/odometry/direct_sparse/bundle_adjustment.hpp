// SPDX-License-Identifier: BSD-3-Clause
// Adjustment of the window, and the prior of what leaves it.
//
// Marginalisation of points and keyframes that leave the window into a quadratic prior (Engel et
// al., PAMI 2018, sections 2.3 and 3.1).
#pragma once

#include <vector>

#include "linear_system.hpp"

namespace tolman::direct_sparse {

/// Keyframes to remove (Engel et al., section 3.1): those with less than 5 % of their points or
/// another brightness, and, if more than `most` remain, the one with the largest distance score
/// (larger when it is close to others and far from the newest). The two newest stay.
std::vector<int> chooseLeaving(const Window& window, int most);

/// Adds points of leaving keyframes, and points that the two newest keyframes do not see, to the
/// prior, linearised at the first estimates; points with little information are dropped.
void marginalisePoints(const CameraRig& rig, const SystemSettings& settings,
                       const std::vector<int>& leaving, double weight, Window& window,
                       LinearSystem& system);

/// Eliminates the variables of the slot from the prior and removes the keyframe.
void marginaliseKeyframe(int slot, Window& window);

/// Projects the gauge null space (pose and brightness of the whole window) out of the prior. The
/// prior has no information there except accumulated rounding errors of float, which would let the
/// window jump after a long drive.
void projectOutGauge(Window& window);

// Windowed photometric bundle adjustment (Engel et al., PAMI 2018, section 2.3; Wang et al., ICCV
// 2017): Gauss-Newton over poses (m, rad), affine brightness, inverse depths (1/m) and
// the disparity offset (px).

struct AdjustmentSettings {
  SystemSettings system;
  int iterations = 4;
  Scale scale = Scale::Known;
  bool watch_field = false;  ///< whether field_rms of the result is wanted while the field is off
};

struct AdjustmentResult {
  int iterations = 0;
  double energy = 0;  ///< before the last step
  int residuals = 0;
  double metres = 0;   ///< largest translation of a keyframe relative to the oldest one
  double radians = 0;  ///< largest rotation of a keyframe relative to the oldest one
  /// px, root mean square over the image of the field of disparity errors without its offset, as it
  /// is, or would be if it were on.
  double field_rms = 0;
};

/// `system` is working memory. Afterwards residual states and point informations belong to the
/// linearisation point of the last step.
AdjustmentResult adjustWindow(const CameraRig& rig, const AdjustmentSettings& settings,
                              Window& window, LinearSystem& system);

/// Removes residuals that are outliers or outside, and points that have no residual left.
void dropOutliers(Window& window);

}  // namespace tolman::direct_sparse
