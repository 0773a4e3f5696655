// SPDX-License-Identifier: BSD-3-Clause
// Conversion to grey and repeated halving.
#include "pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "image_noise.hpp"
#include "wide_lanes.hpp"

namespace tolman::direct_sparse {
namespace {

/// Weights of ITU-R BT.601 in 1/256.
void grayFromBgr(const std::uint8_t* bgr, std::uint8_t* gray, int width) {
  for (int u = 0; u < width; ++u, bgr += 3) {
    gray[u] = static_cast<std::uint8_t>((29 * bgr[0] + 150 * bgr[1] + 77 * bgr[2] + 128) >> 8);
  }
}

/// The pixel of a coarser level at column u. Rounds halves up in one column and down in the next,
/// so that levels do not get brighter.
template <class Value>
TOLMAN_INLINE Value quarter(Value sum, Value odd_column) {
  return (sum + 1 + odd_column) >> 2;
}

/// Sixteen columns of a row from two rows of the finer level.
TOLMAN_INLINE void halveSixteen(const std::uint8_t* p, const std::uint8_t* q, std::uint8_t* out) {
  using Bytes = std::uint8_t __attribute__((vector_size(16)));
  using Shorts = std::uint16_t __attribute__((vector_size(32)));  // pairs of bytes
  constexpr Shorts kOdd = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
  Shorts upper;
  Shorts lower;
  std::memcpy(&upper, p, sizeof upper);
  std::memcpy(&lower, q, sizeof lower);
  const Shorts sum = (upper & 255) + (upper >> 8) + (lower & 255) + (lower >> 8);
  const Bytes bytes = __builtin_convertvector(quarter(sum, kOdd), Bytes);
  std::memcpy(out, &bytes, sizeof bytes);
}

TOLMAN_WIDE_LANES void halve(const GrayLevel& fine, GrayLevel& coarse) {
  for (int v = 0; v < coarse.height; ++v) {
    const std::uint8_t* p = fine.row(2 * v);
    const std::uint8_t* q = fine.row(2 * v + 1);
    std::uint8_t* out = coarse.row(v);
    int u = 0;
    for (; u + 16 <= coarse.width; u += 16) halveSixteen(p + 2 * u, q + 2 * u, out + u);
    for (; u < coarse.width; ++u) {
      const int sum = p[2 * u] + p[2 * u + 1] + q[2 * u] + q[2 * u + 1];
      out[u] = static_cast<std::uint8_t>(quarter(sum, u & 1));
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
    images_[levels_].resize(fine.width / 2, fine.height / 2);
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
