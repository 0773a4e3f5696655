// SPDX-License-Identifier: BSD-3-Clause
#include "engine/pixel_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tolman::imaging {

std::string pixelDoubt(const Pinhole& pinhole, std::string_view whose) {
  constexpr double kMost = 1.05;  // cameras of KITTI, EuRoC and TUM-VI: 1.00 to 1.003; not tuned
  const auto [least, most] = std::minmax(pinhole.fx, pinhole.fy);
  if (!(least > 0) || most <= kMost * least) return "";
  return fmt::format(
      "the focal lengths {}are {:.5g} px horizontally and {:.5g} px "
      "vertically, and pixels of cameras are nearly square: if the images were not resized by "
      "different factors in the two directions, correct fx or fy in the calibration",
      whose, pinhole.fx, pinhole.fy);
}

std::string pixelDoubt(const CameraRig& rig) {
  return rig.calibrated ? pixelDoubt(rig.pinhole, "of the rectified images ") : "";
}

}  // namespace tolman::imaging
