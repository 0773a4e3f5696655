// SPDX-License-Identifier: BSD-3-Clause
// Motion blur of an image, from the depth and the motion of the camera, without tracing more rays.
// It is correct for short paths; moving cars are blurred as if they stood still.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "renderer.hpp"

namespace tolman::town {

/// `T_end_begin`: motion of this camera while its shutter is open; it takes coordinates at the
/// beginning to those at the end. `sharp` (radiance) and `depth` are of the middle of this time.
std::vector<float> shutterBlur(const RenderCamera& view, const std::vector<float>& sharp,
                               const std::vector<float>& depth,
                               const Eigen::Isometry3d& T_end_begin);

}  // namespace tolman::town
