// SPDX-License-Identifier: BSD-3-Clause
// Windowed photometric bundle adjustment (Engel et al., PAMI 2018, section 2.3; Wang et al., ICCV
// 2017): Gauss-Newton over poses (m, rad), affine brightness, inverse depths (1/m) and
// the disparity offset (px).
#pragma once

#include "linear_system.hpp"

namespace tolman::direct_sparse {

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
