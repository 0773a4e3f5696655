// SPDX-License-Identifier: BSD-3-Clause
#include "engine/brightness.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace tolman::imaging {

int brightest(const Image& image) {
  constexpr std::size_t kShare = 10'000;
  if (image.empty()) return -1;
  const std::ptrdiff_t bytes = std::ptrdiff_t{image.width()} * bytesPerPixel(image.format());
  std::array<std::size_t, 256> counts = {};
  for (int r = 0; r < image.height(); ++r) {
    const std::uint8_t* row = image.row(r);
    std::for_each(row, row + bytes, [&](std::uint8_t value) { ++counts[value]; });
  }
  const std::size_t few =
      static_cast<std::size_t>(bytes) * static_cast<std::size_t>(image.height()) / kShare;
  std::size_t beyond = 0;
  int value = 255;
  while (value > 0 && (beyond += counts[static_cast<std::size_t>(value)]) <= few) --value;
  return value;
}

}  // namespace tolman::imaging
