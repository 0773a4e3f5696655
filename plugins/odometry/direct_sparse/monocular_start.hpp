// SPDX-License-Identifier: BSD-3-Clause
// Start of a single camera: assumed depths (1/m) for the first keyframe, against which frames are
// tracked until their motion has determined the real ones.
#pragma once

#include "keyframe.hpp"
#include "tolman/camera.hpp"

namespace tolman::direct_sparse {

/// Assigns each candidate its inverse depth in a street of ground and two side walls. `height`: of
/// the camera above the ground, m. The shape need only be close enough for tracking; the standard
/// deviation is half the inverse depth.
void draftDepths(const CameraRig& rig, double height, Keyframe& keyframe);

/// Makes points at the present depths of all candidates, for tracking; they have no residuals.
void draftPoints(Keyframe& keyframe);

}  // namespace tolman::direct_sparse
