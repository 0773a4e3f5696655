// SPDX-License-Identifier: BSD-3-Clause
// Windows over the rendered street, with points whose depth is known.
#pragma once

#include <memory>
#include <vector>

#include "photometric_residual.hpp"
#include "support/street_scene.hpp"
#include "window.hpp"

namespace tolman::test {

/// Camera at `z` metres along the street, turned by `yaw`.
Eigen::Isometry3d streetPose(double z, double yaw = 0);

/// True inverse depth of a pixel of the camera at this pose.
double streetInverseDepth(const Eigen::Isometry3d& T_world_camera, double u, double v);

/// Keyframes at the poses (frames 0, 1, ...), with both images and no points.
std::unique_ptr<direct_sparse::Window> streetWindow(const std::vector<Eigen::Isometry3d>& poses);

/// About `wanted` points of true depth in each keyframe, with residuals to all others.
void addTruePoints(direct_sparse::Window& window, int wanted);

/// The sums of a point in a target; false where it is not seen.
bool sumsIn(const direct_sparse::PairGeometry& pair, const direct_sparse::GrayLevel& target,
            const direct_sparse::Point& point, direct_sparse::PixelSums& sums);

/// A pyramid of the left image at a pose.
direct_sparse::ImagePyramid streetPyramid(const Eigen::Isometry3d& T_world_camera);

/// An image of one function of the pixel.
template <class Function>
direct_sparse::GrayLevel levelOf(int width, int height, Function&& function) {
  direct_sparse::GrayLevel level;
  level.resize(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) level.row(v)[u] = static_cast<std::uint8_t>(function(u, v));
  }
  return level;
}

}  // namespace tolman::test
