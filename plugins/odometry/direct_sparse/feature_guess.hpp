// SPDX-License-Identifier: BSD-3-Clause
// Position of a corner of one image in another one, to a fraction of a pixel, in both directions.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "pyramid.hpp"
#include "tolman/camera.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

inline constexpr int kLargestPatchRadius = 7;  // px

/// Pixel of `there` that shows what `here` shows at (u, v): Gauss-Newton steps from `start` (Lucas
/// and Kanade 1981; with gradients of the first image, as Baker and Matthews 2004) for a square
/// patch of 2 radius + 1 pixels a side. `gain`: grey levels of `there` over those of `here`; a
/// constant difference is removed. `radius`: at most kLargestPatchRadius. Empty where the patch is
/// no corner, does not fit, or is farther than 1.5 px from `start`.
std::optional<Eigen::Vector2f> matchPatch(const GrayLevel& here, int u, int v,
                                          const GrayLevel& there, const Eigen::Vector2f& start,
                                          float gain, int radius);

// A guess of the pose for when direct alignment has failed, which converges only from a few pixels
// away and fails behind a vehicle that covers the scene. Points of the window are tracked by the
// optical flow of Lucas and Kanade. RANSAC over their pixels (PnP) gives the pose, so that points
// on moving objects are outliers.

/// Pose of the newest keyframe in the camera frame of `image`; `expected` is its prediction. Empty
/// if too few points agree.
std::optional<Eigen::Isometry3d> guessByFeatures(const CameraRig& rig, const Window& window,
                                                 const GrayLevel& image,
                                                 const Eigen::Isometry3d& expected);

}  // namespace tolman::direct_sparse
