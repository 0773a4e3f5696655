// SPDX-License-Identifier: BSD-3-Clause
// Yaw (rad) from a horizontal image shift. OpenRatSLAM does not use the shift of ordinary cameras.
#pragma once

#include <cmath>
#include <numbers>

#include "tolman/geometry.hpp"

namespace tolman::view_templates {

/// Focal length (px) of a pinhole that sees `field_of_view` (rad) over `width` pixels.
inline double focalOfFieldOfView(double field_of_view, int width) {
  return 0.5 * width / std::tan(0.5 * field_of_view);
}

/// Yaw (rad, positive to the left) of a pinhole camera whose scene moved `right_px` to the right:
/// when the camera turns left, the scene moves right in the image.
inline double yawOfPinholeShift(double right_px, double focal_px) {
  return std::atan(right_px / focal_px);
}

/// The same for a panorama of `columns` cells over the full turn.
inline double yawOfPanoramicShift(double right_cells, int columns) {
  return wrapAngle(2 * std::numbers::pi * right_cells / columns);
}

}  // namespace tolman::view_templates
