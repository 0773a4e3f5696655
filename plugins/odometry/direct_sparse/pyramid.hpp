// SPDX-License-Identifier: BSD-3-Clause
// The image pyramid: grey bytes, each level the mean of 2x2 pixels of the one below. An odd last
// row or column is left out of the next level, so every image size has a full pyramid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tolman/image.hpp"

namespace tolman::direct_sparse {

/// One level. Pixels are packed; a few bytes behind the last one may be read (they are zero).
struct GrayLevel {
  static constexpr std::size_t kPadding = 32;  // bytes
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;

  void resize(int new_width, int new_height);
  const std::uint8_t* row(int v) const {
    return pixels.data() + static_cast<std::ptrdiff_t>(v) * width;
  }
  std::uint8_t* row(int v) { return pixels.data() + static_cast<std::ptrdiff_t>(v) * width; }
  /// Whether a bilinear value, with a border of `margin` pixels around, lies inside.
  bool contains(float u, float v, float margin) const {
    return u >= margin && v >= margin && u < static_cast<float>(width) - 1.0F - margin &&
           v < static_cast<float>(height) - 1.0F - margin;
  }
  /// Bilinear; (u, v) must lie in [0, width - 1) x [0, height - 1).
  float at(float u, float v) const {
    const int x = static_cast<int>(u);
    const int y = static_cast<int>(v);
    const float fx = u - static_cast<float>(x);
    const float fy = v - static_cast<float>(y);
    const std::uint8_t* p = row(y) + x;
    const std::uint8_t* q = p + width;
    const auto p0 = static_cast<float>(p[0]);
    const auto q0 = static_cast<float>(q[0]);
    const float top = p0 + fx * (static_cast<float>(p[1]) - p0);
    const float bottom = q0 + fx * (static_cast<float>(q[1]) - q0);
    return top + fy * (bottom - top);
  }
};

/// Conversion of image coordinates between a level and level 0: pixel centres are whole numbers on
/// every level.
inline float toLevel(float pixel, int level) {
  return (pixel + 0.5F) / static_cast<float>(1 << level) - 0.5F;
}

class ImagePyramid {
 public:
  static constexpr int kMaxLevels = 6;  // as in DSO

  /// Whether noisy images are smoothed first (image_noise.hpp).
  enum class Noise : std::uint8_t { Keep, Smooth };

  /// Reuses its memory. Levels stop before a side falls below 16 px, or at `most`.
  void build(const Image& image, int most = kMaxLevels, Noise noise = Noise::Keep);
  /// Removes all levels; keeps the memory.
  void clear() { levels_ = 0; }
  int levels() const { return levels_; }
  const GrayLevel& level(int l) const { return images_[l]; }
  GrayLevel& level(int l) { return images_[l]; }
  bool empty() const { return levels_ == 0; }

 private:
  GrayLevel images_[kMaxLevels];
  std::vector<std::uint8_t> buffer_;
  int levels_ = 0;
};

/// Contrast of an image: standard deviation of grey levels on a grid of pixels, and their mean.
struct GrayStatistics {
  float mean = 0;
  float deviation = 0;
};
GrayStatistics grayStatistics(const GrayLevel& image);

// The noise of an image, and a filter for noisy ones. In the dark a camera amplifies noise until it
// has the gradients of weak texture: points are then chosen on noise, their depths are chance, and
// the scale and the shape of a window of a single camera follow them (docs/report/odometry.md).

/// Standard deviation of the noise, grey levels, from the differences that a plane of grey values
/// does not have (Immerkaer, CVIU 1996). Their lower quartile is taken, not their mean, because
/// texture makes differences too; images full of fine texture still seem noisier than they are.
/// 0 where all pixels are black or saturated.
float imageNoise(const GrayLevel& image);

/// Share, 0 to 1, of the smoothed image that images of this noise are mixed with.
float smoothedShare(float noise);

/// Mixes the image with its average over 3 x 3 pixels (weights 1 2 1; pixels at the border are
/// repeated). `before` is a buffer.
void smooth(GrayLevel& image, float share, std::vector<std::uint8_t>& before);

}  // namespace tolman::direct_sparse
