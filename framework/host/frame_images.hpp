// SPDX-License-Identifier: BSD-3-Clause
// Checks the images of a frame against the rig.
#pragma once

#include "tolman/camera.hpp"
#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

/// Requires valid pixels, rows that do not overlap, and the sizes of the rig; and of a pair either
/// both images in one format or none.
Status checkImages(const Frame& frame, const CameraRig& rig);

// Whether the cameras that a source describes can exist. A source knows more of its own data; this
// is what holds for all of them, plugins of others included.

/// Refuses sizes and baselines below 0 and, of calibrated cameras, focal lengths that no lens has
/// and principal points far from the image. The values must be finite (values.hpp).
Status checkRig(const CameraRig& rig);

}  // namespace tolman::host
