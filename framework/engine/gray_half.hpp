// SPDX-License-Identifier: BSD-3-Clause
// A grey image of half the width and height, for checks that need no more.
#pragma once

#include <cstdint>
#include <vector>

#include "tolman/image.hpp"

namespace tolman::imaging {

struct GrayHalf {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< row by row

  const std::uint8_t* row(int r) const { return pixels.data() + std::ptrdiff_t{r} * width; }
};

/// Each pixel is the mean of four. Of a colour image the green channel stands for grey.
GrayHalf grayHalf(const Image& image);

}  // namespace tolman::imaging
