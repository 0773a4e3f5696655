// SPDX-License-Identifier: BSD-3-Clause
// A guess of the pose for when direct alignment has failed, which converges only from a few pixels
// away and fails behind a vehicle that covers the scene. Points of the window are tracked by the
// optical flow of Lucas and Kanade. RANSAC over their pixels (PnP) gives the pose, so that points
// on moving objects are outliers.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "tolman/camera.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

/// Pose of the newest keyframe in the camera frame of `image`; `expected` is its prediction. Empty
/// if too few points agree.
std::optional<Eigen::Isometry3d> guessByFeatures(const CameraRig& rig, const Window& window,
                                                 const GrayLevel& image,
                                                 const Eigen::Isometry3d& expected);

}  // namespace tolman::direct_sparse
