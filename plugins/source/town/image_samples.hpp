// SPDX-License-Identifier: BSD-3-Clause
// Values of an image between its pixels, and means over boxes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tolman::town {

/// Bilinear interpolation; outside of the image the value at its border.
struct ImageSamples {
  const std::vector<float>& values;
  int width;
  int height;

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
  float at(float u, float v) const {
    u = std::clamp(u, 0.0F, static_cast<float>(width - 1));
    v = std::clamp(v, 0.0F, static_cast<float>(height - 1));
    return interpolate(std::min(static_cast<int>(u), width - 2),
                       std::min(static_cast<int>(v), height - 2), u, v);
  }
  /// The same for 0 <= u < width - 1 and 0 <= v < height - 1.
  float inside(float u, float v) const {
    return interpolate(static_cast<int>(u), static_cast<int>(v), u, v);
  }

 private:
  float interpolate(int c, int r, float u, float v) const {
    const float fu = u - static_cast<float>(c);
    const float fv = v - static_cast<float>(r);
    const std::size_t i = index(c, r);
    const std::size_t below = i + static_cast<std::size_t>(width);
    return (1 - fv) * ((1 - fu) * values[i] + fu * values[i + 1]) +
           fv * ((1 - fu) * values[below] + fu * values[below + 1]);
  }
};

/// Mean over a box of 2 * radius + 1 px, along rows and then along columns; at the border over the
/// part inside of the image.
std::vector<float> boxBlur(const std::vector<float>& values, int width, int height, int radius);

}  // namespace tolman::town
