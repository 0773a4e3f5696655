// SPDX-License-Identifier: BSD-3-Clause
// Falling rain in front of the cameras: short bright lines, with the same drops for both cameras.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer.hpp"

namespace tolman::town {

struct Rain {
  float density = 0;     ///< 0 none, 1 heavy
  float brightness = 0;  ///< radiance of a drop: that of the sky
  double exposure_s = 0.005;
  double speed_m_s = 8;    ///< of the camera along its axis
  std::uint32_t seed = 0;  ///< different for each frame
};

/// The drops are placed in the coordinates of the left camera; `T_left_camera` is the pose of this
/// one.
void addRain(std::vector<float>& radiance, const RenderCamera& view,
             const Eigen::Isometry3d& T_left_camera, const Rain& rain);

}  // namespace tolman::town
