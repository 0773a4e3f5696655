// SPDX-License-Identifier: BSD-3-Clause
// Chooses the rectified cameras for raw ones: their rotations, and the rectangle of their common
// view that the images show.
#pragma once

#include <string>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

struct ViewOptions {
  double scale = 1;           ///< pixels of the rectified image per raw pixel, at the centre
  double field_of_view = 90;  ///< deg; largest angle across and down if none is prescribed
};

struct RectifiedView {
  CameraRig rig;
  std::vector<Eigen::Matrix3d> R_rectified_raw;  ///< one for each raw camera
  bool is_identity = false;                      ///< the images are rectified already
};

/// The view that the calibration prescribes, else the largest rectangle that all cameras show
/// completely. Two cameras are rotated so that their x axes are along the baseline, and their
/// optical axes by equal angles towards each other. A failure says what is wrong in the
/// calibration, and what to do.
Result<RectifiedView> chooseView(const RawRig& raw, const ViewOptions& options);

/// "2 radial_tangential cameras of 752x480 px, rectified to 703x431 px, 73 x 50 deg"
std::string viewText(const RawRig& raw, const RectifiedView& view);

}  // namespace tolman::engine
