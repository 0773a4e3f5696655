// SPDX-License-Identifier: BSD-3-Clause
#include "jpeg_noise.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tolman::town {
namespace {

constexpr int kSide = 8;
using Block = std::array<std::array<float, kSide>, kSide>;

/// ITU-T T.81, table K.1.
constexpr std::array<std::array<int, kSide>, kSide> kLuminance = {
    {{16, 11, 10, 16, 24, 40, 51, 61},
     {12, 12, 14, 19, 26, 58, 60, 55},
     {14, 13, 16, 24, 40, 57, 69, 56},
     {14, 17, 22, 29, 51, 87, 80, 62},
     {18, 22, 37, 56, 68, 109, 103, 77},
     {24, 35, 55, 64, 81, 104, 113, 92},
     {49, 64, 78, 87, 103, 121, 120, 101},
     {72, 92, 95, 98, 112, 100, 103, 99}}};

Block quantisation(int quality) {
  const int percent = quality < 50 ? 5000 / quality : 200 - 2 * quality;
  Block steps;
  for (std::size_t r = 0; r < kSide; ++r) {
    for (std::size_t c = 0; c < kSide; ++c) {
      steps[r][c] = static_cast<float>(std::clamp((kLuminance[r][c] * percent + 50) / 100, 1, 255));
    }
  }
  return steps;
}

/// Orthonormal matrix of the cosine transform: row k has the frequency k.
Block cosines() {
  Block basis;
  for (std::size_t k = 0; k < kSide; ++k) {
    const double norm = k == 0 ? std::sqrt(0.125) : 0.5;
    for (std::size_t i = 0; i < kSide; ++i) {
      const double angle = std::numbers::pi * static_cast<double>(k * (2 * i + 1)) / (2.0 * kSide);
      basis[k][i] = static_cast<float>(norm * std::cos(angle));
    }
  }
  return basis;
}

Block product(const Block& a, const Block& b) {
  Block result{};
  for (std::size_t r = 0; r < kSide; ++r) {
    for (std::size_t k = 0; k < kSide; ++k) {
      for (std::size_t c = 0; c < kSide; ++c) result[r][c] += a[r][k] * b[k][c];
    }
  }
  return result;
}

Block transposed(const Block& a) {
  Block result;
  for (std::size_t r = 0; r < kSide; ++r) {
    for (std::size_t c = 0; c < kSide; ++c) result[c][r] = a[r][c];
  }
  return result;
}

}  // namespace

Image throughJpeg(const Image& image, int quality) {
  const Block steps = quantisation(quality);
  const Block forward = cosines();
  const Block backward = transposed(forward);
  const int width = image.width();
  const int height = image.height();
  const auto compress = [&](int left, int top, std::uint8_t* out) {
    Block block;
    for (int r = 0; r < kSide; ++r) {
      const std::uint8_t* row = image.row(std::min(top + r, height - 1));
      for (int c = 0; c < kSide; ++c) {
        block[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] =
            static_cast<float>(row[std::min(left + c, width - 1)]) - 128;
      }
    }
    Block waves = product(product(forward, block), backward);
    for (std::size_t r = 0; r < kSide; ++r) {
      for (std::size_t c = 0; c < kSide; ++c) {
        waves[r][c] = steps[r][c] * std::round(waves[r][c] / steps[r][c]);
      }
    }
    const Block back = product(product(backward, waves), forward);
    for (int r = 0; r < std::min(kSide, height - top); ++r) {
      for (int c = 0; c < std::min(kSide, width - left); ++c) {
        const float level = back[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] + 128.5F;
        out[std::ptrdiff_t{top + r} * width + left + c] =
            static_cast<std::uint8_t>(std::clamp(level, 0.0F, 255.0F));
      }
    }
  };
  return Image::create(width, height, PixelFormat::Gray8, [&](std::uint8_t* out) {
    oneapi::tbb::parallel_for(0, (height + kSide - 1) / kSide, [&](int block_row) {
      for (int left = 0; left < width; left += kSide) compress(left, block_row * kSide, out);
    });
  });
}

}  // namespace tolman::town
