// SPDX-License-Identifier: BSD-3-Clause
// Whether the cameras that a source describes can exist. A source knows more of its own data; this
// is what holds for all of them, plugins of others included.
#pragma once

#include "tolman/camera.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

/// Refuses sizes and baselines below 0 and, of calibrated cameras, focal lengths that no lens has
/// and principal points far from the image. The values must be finite (values.hpp).
Status checkRig(const CameraRig& rig);

}  // namespace tolman::host
