// SPDX-License-Identifier: BSD-3-Clause
// Whether the two focal lengths of a camera fit each other: pixels of cameras are nearly
// square.
#pragma once

#include <string>
#include <string_view>

#include "tolman/camera.hpp"

namespace tolman::imaging {

/// What to look at where the focal lengths of the two directions differ by more than 5 %; empty for
/// others. `whose`: "of the rectified images ", or empty.
std::string pixelDoubt(const Pinhole& pinhole, std::string_view whose);

/// The same of rectified images; empty for images without a calibration.
std::string pixelDoubt(const CameraRig& rig);

}  // namespace tolman::imaging
