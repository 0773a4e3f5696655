// SPDX-License-Identifier: BSD-3-Clause
// Light beyond saturation that spreads over the image.
#pragma once

#include <vector>

namespace tolman::town {

/// Adds the share `bloom` of the radiance above `saturation` to the pixels around it: in a narrow
/// and a wide halo of 4 and 40 px at `scale` 1, half of the light in each.
void addBloom(std::vector<float>& radiance, int width, int height, float saturation, float bloom,
              double scale);

}  // namespace tolman::town
