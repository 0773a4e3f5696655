// SPDX-License-Identifier: BSD-3-Clause
// Grey value and gradient of each pixel, interleaved, so that one bilinear interpolation gives all
// three.
#pragma once

#include <cstdint>
#include <vector>

#include "lanes.hpp"
#include "large_pages.hpp"
#include "pyramid.hpp"

namespace tolman::direct_sparse {

struct GradientSample {
  float value = 0;
  float gx = 0;  ///< grey levels a pixel
  float gy = 0;
};

/// Central differences. Four whole numbers per pixel: value, I(u+1) - I(u-1), I(v+1) - I(v-1), 0.
/// The gradient of the outermost pixels is 0.
class GradientImage {
 public:
  void build(const GrayLevel& image);
  int width() const { return width_; }
  int height() const { return height_; }
  const std::int16_t* pixel(int u, int v) const {
    return quads_.data() +
           4 * (static_cast<std::ptrdiff_t>(v) * width_ + static_cast<std::ptrdiff_t>(u));
  }
  /// Squared gradient at a pixel, (grey levels / px)^2.
  float gradientSquared(int u, int v) const {
    const std::int16_t* p = pixel(u, v);
    return 0.25F * static_cast<float>(p[1] * p[1] + p[2] * p[2]);
  }
  bool contains(float u, float v, float margin) const {
    return u >= margin && v >= margin && u < static_cast<float>(width_) - 1.0F - margin &&
           v < static_cast<float>(height_) - 1.0F - margin;
  }
  /// Bilinear value, difference in u, difference in v at a fraction (fx, fy) right and below of a
  /// pixel, in steps of 1/128; differences are twice the gradient.
  Four at(int x, int y, float fx, float fy) const {
    const std::int16_t* p = pixel(x, y);
    return mixShorts(p, p + 4 * static_cast<std::ptrdiff_t>(width_), fx, fy);
  }
  /// The same; (u, v) must lie in [0, width - 1) x [0, height - 1).
  GradientSample at(float u, float v) const {
    const int x = static_cast<int>(u);
    const int y = static_cast<int>(v);
    const Four value = at(x, y, u - static_cast<float>(x), v - static_cast<float>(y));
    return {value[0], 0.5F * value[1], 0.5F * value[2]};
  }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<std::int16_t, LargePages<std::int16_t>> quads_;
};

}  // namespace tolman::direct_sparse
