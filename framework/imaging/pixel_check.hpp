// SPDX-License-Identifier: BSD-3-Clause
// Whether the focal lengths of a rectified image fit each other: pixels of cameras are nearly
// square.
#pragma once

#include <string>

#include "tolman/camera.hpp"

namespace tolman::imaging {

/// What to look at where the focal lengths of the two directions differ by more than 5 %; empty for
/// others, and for images without a calibration.
std::string pixelDoubt(const CameraRig& rig);

}  // namespace tolman::imaging
