// SPDX-License-Identifier: BSD-3-Clause
#include "imaging/brightness.hpp"

#include <algorithm>

namespace tolman::imaging {

int brightest(const Image& image) {
  int largest = -1;
  if (image.empty()) return largest;
  const std::ptrdiff_t bytes = std::ptrdiff_t{image.width()} * bytesPerPixel(image.format());
  for (int r = 0; r < image.height(); ++r) {
    const std::uint8_t* row = image.row(r);
    largest = std::max<int>(largest, *std::max_element(row, row + bytes));
  }
  return largest;
}

}  // namespace tolman::imaging
