// SPDX-License-Identifier: BSD-3-Clause
// Small grey and colour images for tests, by formula or random.
#pragma once

#include <cstdint>
#include <cstring>

#include "tolman/context.hpp"
#include "tolman/image.hpp"

namespace tolman::test {

/// A grey image whose pixels are value(x, y).
inline Image gray(int width, int height, auto&& value) {
  return Image::create(width, height, PixelFormat::Gray8, [&](std::uint8_t* pixel) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) *pixel++ = static_cast<std::uint8_t>(value(x, y));
    }
  });
}

inline Image noise(int width, int height, RandomStream& random) {
  return gray(width, height, [&](int, int) { return random.below(256); });
}

/// A colour image with three equal channels.
inline Image coloured(const Image& gray) {
  return Image::create(gray.width(), gray.height(), PixelFormat::Bgr8, [&](std::uint8_t* pixel) {
    for (int y = 0; y < gray.height(); ++y) {
      for (int x = 0; x < gray.width(); ++x, pixel += 3) std::memset(pixel, gray.row(y)[x], 3);
    }
  });
}

}  // namespace tolman::test
