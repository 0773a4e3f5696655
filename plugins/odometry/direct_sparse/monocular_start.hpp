// SPDX-License-Identifier: BSD-3-Clause
// The first keyframe of a single camera: a drafted scene to track against until the motion has
// shown the depths.
#pragma once

#include "keyframe.hpp"
#include "tolman/camera.hpp"

namespace tolman::direct_sparse {

/// Gives each candidate the inverse depth that it would have in a street: ground below, walls at
/// the sides, both in units of `height`, the camera's height above the ground. The shape only has
/// to be near enough for tracking; its deviation says how little is known.
void draftDepths(const CameraRig& rig, double height, Keyframe& keyframe);

/// Points at the present depths of all candidates, for tracking; they carry no residuals.
void draftPoints(Keyframe& keyframe);

}  // namespace tolman::direct_sparse
