// SPDX-License-Identifier: BSD-3-Clause
// A first guess of the pose where direct alignment has failed: it converges only from a few pixels
// away, and a vehicle in front of the scene misleads it. Points of the window are followed by the
// optical flow of Lucas and Kanade, and the pose is found from the pixels where they are (PnP) by
// consensus, so that those on moving objects do not count.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "tolman/camera.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

/// Pose of the newest keyframe in the camera frame of `image`; `expected` is its prediction. None
/// where too few points agree.
std::optional<Eigen::Isometry3d> guessByFeatures(const CameraRig& rig, const Window& window,
                                                 const GrayLevel& image,
                                                 const Eigen::Isometry3d& expected);

}  // namespace tolman::direct_sparse
