// SPDX-License-Identifier: BSD-3-Clause
// Whether the images of a frame are those that the rig promises.
#pragma once

#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

/// Pixels are there, rows do not overlap, sizes are the rig's; of a pair both images or none, in
/// one format.
Status checkImages(const Frame& frame, const CameraRig& rig);

}  // namespace tolman::host
