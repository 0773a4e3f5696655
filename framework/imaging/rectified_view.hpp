// SPDX-License-Identifier: BSD-3-Clause
// Chooses the rectified cameras for raw ones: how each is turned, and which rectangle of their
// common view the images show.
#pragma once

#include <string>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/status.hpp"

namespace tolman::imaging {

struct ViewOptions {
  double scale = 1;           ///< pixels of the rectified image per raw pixel, at the centre
  double field_of_view = 90;  ///< deg, the most across and down, where none is prescribed
};

struct RectifiedView {
  CameraRig rig;
  std::vector<Eigen::Matrix3d> R_rectified_raw;  ///< one for each raw camera
  bool is_identity = false;                      ///< the images are rectified as they are
};

/// The view that the calibration prescribes, else the largest rectangle that all cameras show
/// completely. Two cameras are turned so that their x axes lie along the baseline, and by equal
/// parts towards each other. A failure says what in the calibration cannot be, and what to do.
Result<RectifiedView> chooseView(const RawRig& raw, const ViewOptions& options);

/// "2 radial_tangential cameras of 752x480 px, rectified to 703x431 px, 73 x 50 deg"
std::string viewText(const RawRig& raw, const RectifiedView& view);

}  // namespace tolman::imaging
