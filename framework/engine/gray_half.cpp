// SPDX-License-Identifier: BSD-3-Clause
#include "engine/gray_half.hpp"

namespace tolman::imaging {

GrayHalf grayHalf(const Image& image) {
  GrayHalf half{image.width() / 2, image.height() / 2, {}};
  half.pixels.resize(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  const int step = bytesPerPixel(image.format());
  const int channel = step == 3 ? 1 : 0;
  std::uint8_t* out = half.pixels.data();
  for (int r = 0; r < half.height; ++r) {
    const std::uint8_t* a = image.row(2 * r) + channel;
    const std::uint8_t* b = image.row(2 * r + 1) + channel;
    for (int c = 0; c < half.width; ++c, a += 2 * step, b += 2 * step) {
      *out++ = static_cast<std::uint8_t>((a[0] + a[step] + b[0] + b[step] + 2) / 4);
    }
  }
  return half;
}

}  // namespace tolman::imaging
