// SPDX-License-Identifier: BSD-3-Clause
// Blur of an image while the shutter is open, from the depth and the motion of the camera: no ray
// is traced again. Right for short paths; moving cars blur as if they stood.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "renderer.hpp"

namespace tolman::town {

/// `T_end_begin`: motion of this camera while its shutter is open, its pose at the end seen from
/// points at the begin. The middle of that time is what `sharp` (radiance) and `depth` show.
std::vector<float> shutterBlur(const RenderCamera& view, const std::vector<float>& sharp,
                               const std::vector<float>& depth,
                               const Eigen::Isometry3d& T_end_begin);

}  // namespace tolman::town
