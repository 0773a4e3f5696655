// SPDX-License-Identifier: BSD-3-Clause
// Falling rain before the cameras: short bright lines, the same drops for both.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer.hpp"

namespace tolman::town {

struct Rain {
  float density = 0;     ///< 0 none, 1 heavy
  float brightness = 0;  ///< radiance that a drop refracts: that of the sky
  double exposure_s = 0.005;
  double speed_m_s = 8;    ///< of the camera along its axis
  std::uint32_t seed = 0;  ///< of this moment
};

/// `T_left_camera` places the drops, which are drawn about the left camera.
void addRain(std::vector<float>& radiance, const RenderCamera& view,
             const Eigen::Isometry3d& T_left_camera, const Rain& rain);

}  // namespace tolman::town
