// SPDX-License-Identifier: BSD-3-Clause
// Checks the images of a frame against the rig.
#pragma once

#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

/// Requires valid pixels, rows that do not overlap, and the sizes of the rig; and of a pair either
/// both images in one format or none.
Status checkImages(const Frame& frame, const CameraRig& rig);

}  // namespace tolman::host
