// SPDX-License-Identifier: BSD-3-Clause
// Conversion to grey and repeated halving.
#include "pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "image_noise.hpp"

namespace tolman::direct_sparse {
namespace {

/// Weights of ITU-R BT.601 in 1/256.
void grayFromBgr(const std::uint8_t* bgr, std::uint8_t* gray, int width) {
  for (int u = 0; u < width; ++u, bgr += 3) {
    gray[u] = static_cast<std::uint8_t>((29 * bgr[0] + 150 * bgr[1] + 77 * bgr[2] + 128) >> 8);
  }
}

void halve(const GrayLevel& fine, GrayLevel& coarse) {
  coarse.resize(fine.width / 2, fine.height / 2);
  for (int v = 0; v < coarse.height; ++v) {
    const std::uint8_t* p = fine.row(2 * v);
    const std::uint8_t* q = fine.row(2 * v + 1);
    std::uint8_t* out = coarse.row(v);
    for (int u = 0; u < coarse.width; ++u) {
      const int sum = p[2 * u] + p[2 * u + 1] + q[2 * u] + q[2 * u + 1];
      // Rounds halves up in one column and down in the next, so that levels do not get brighter.
      out[u] = static_cast<std::uint8_t>((sum + 1 + (u & 1)) >> 2);
    }
  }
}

}  // namespace

void GrayLevel::resize(int new_width, int new_height) {
  if (width == new_width && height == new_height) return;
  width = new_width;
  height = new_height;
  const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  pixels.assign(size + kPadding, 0);
}

void ImagePyramid::build(const Image& image, int most, Noise noise) {
  constexpr int kSmallestSide = 16;  // px; chosen, not tuned
  GrayLevel& base = images_[0];
  base.resize(image.width(), image.height());
  for (int v = 0; v < base.height; ++v) {
    if (image.format() == PixelFormat::Bgr8) {
      grayFromBgr(image.row(v), base.row(v), base.width);
    } else {
      std::memcpy(base.row(v), image.row(v), static_cast<std::size_t>(base.width));
    }
  }
  if (noise == Noise::Smooth) smooth(base, smoothedShare(imageNoise(base)), buffer_);
  levels_ = 1;
  while (levels_ < most) {
    const GrayLevel& fine = images_[levels_ - 1];
    if (std::min(fine.width, fine.height) < 2 * kSmallestSide) break;
    halve(fine, images_[levels_]);
    ++levels_;
  }
}

GrayStatistics grayStatistics(const GrayLevel& image) {
  constexpr int kStep = 4;  // px; bounds the time
  double sum = 0;
  double squares = 0;
  double count = 0;
  for (int v = 0; v < image.height; v += kStep) {
    const std::uint8_t* row = image.row(v);
    int row_sum = 0;
    int row_squares = 0;
    for (int u = 0; u < image.width; u += kStep) {
      row_sum += row[u];
      row_squares += row[u] * row[u];
    }
    sum += row_sum;
    squares += row_squares;
    const int samples = (image.width + kStep - 1) / kStep;
    count += samples;
  }
  if (!(count > 0)) return {};
  const double mean = sum / count;
  return {static_cast<float>(mean),
          static_cast<float>(std::sqrt(std::max(0.0, squares / count - mean * mean)))};
}

}  // namespace tolman::direct_sparse
