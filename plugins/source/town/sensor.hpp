// SPDX-License-Identifier: BSD-3-Clause
// From radiance to grey levels: exposure, vignetting, shot and read noise, response, 8 bits.
#pragma once

#include <cstdint>
#include <vector>

#include "tolman/image.hpp"

namespace tolman::town {

struct Sensor {
  int width = 0;
  int height = 0;
  double gain = 255;       ///< grey levels for a radiance of 1
  double gamma = 1;        ///< exponent of the response, between black and saturation
  double vignetting = 0;   ///< relative loss of light in the corners
  double read_noise = 0;   ///< grey levels, standard deviation
  double shot_noise = 0;   ///< variance per grey level
  std::uint32_t seed = 0;  ///< of the run; noise depends only on it, the exposure and the pixel
};

/// Quantises radiance to an 8-bit image. `exposure` is the number of the image in the run,
/// different for left and right; it selects the noise.
Image expose(const Sensor& sensor, const std::vector<float>& radiance, std::uint32_t exposure);

}  // namespace tolman::town
