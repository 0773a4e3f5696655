// SPDX-License-Identifier: BSD-3-Clause
// From radiance to grey levels: rain before the camera, light that spreads in its lens, and the
// sensor.
#pragma once

#include <cstdint>
#include <vector>

#include "light.hpp"
#include "renderer.hpp"
#include "tolman/image.hpp"

namespace tolman::town {

/// Image size in px and its ratio to the full size, on which the sizes of halos depend.
struct ImageSize {
  int width = 0;
  int height = 0;
  double scale = 1;
};

struct Rain {
  float density = 0;     ///< 0 none, 1 heavy
  float brightness = 0;  ///< radiance of a drop: that of the sky
  double exposure_s = 0.005;
  double speed_m_s = 8;    ///< of the camera along its axis
  std::uint32_t seed = 0;  ///< different for each frame
};

/// Short bright lines, placed in the coordinates of the left camera, so that both cameras see the
/// same drops; `T_left_camera` is the pose of this one.
void addRain(std::vector<float>& radiance, const RenderCamera& view,
             const Eigen::Isometry3d& T_left_camera, const Rain& rain);

/// Adds the share `bloom` of the radiance above `saturation` to the pixels around it: in a narrow
/// and a wide halo of 4 and 40 px at scale 1, half of the light in each.
void addBloom(std::vector<float>& radiance, const ImageSize& size, float saturation, float bloom);

struct Exposure {
  double time_ms = 0;
  double amplification = 1;  ///< of signal and noise, if the longest time is too short
};

/// `ms`: [always], or [in the sun of a clear noon, the longest].
Exposure exposureFor(const Light& light, const std::vector<double>& ms);

struct Sensor {
  int width = 0;
  int height = 0;
  double gain = 255;       ///< grey levels for a radiance of 1
  double vignetting = 0;   ///< relative loss of light in the corners
  double read_noise = 0;   ///< grey levels, standard deviation
  double shot_noise = 0;   ///< variance per grey level
  std::uint32_t seed = 0;  ///< of the run; noise depends only on it, the exposure and the pixel
};

/// Quantises radiance to an 8-bit image. `exposure` is the number of the image in the run,
/// different for left and right; it selects the noise.
Image expose(const Sensor& sensor, const std::vector<float>& radiance, std::uint32_t exposure);

}  // namespace tolman::town
