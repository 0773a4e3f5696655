// SPDX-License-Identifier: BSD-3-Clause
// Central differences of a whole level.
#include "gradient_image.hpp"

#include <tbb/parallel_for.h>

namespace tolman::direct_sparse {

void GradientImage::build(const GrayLevel& image) {
  if (width_ != image.width || height_ != image.height) {
    width_ = image.width;
    height_ = image.height;
    quads_.assign(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0);
  }
  tbb::parallel_for(0, height_, [&](int v) {
    const bool inner = v > 0 && v < height_ - 1;
    const std::uint8_t* here = image.row(v);
    const std::uint8_t* above = inner ? image.row(v - 1) : here;
    const std::uint8_t* below = inner ? image.row(v + 1) : here;
    std::int16_t* out = quads_.data() + 4 * static_cast<std::ptrdiff_t>(v) * width_;
    out[0] = here[0];
    for (int u = 1; u < width_ - 1; ++u) {
      out[4 * u] = here[u];
      out[4 * u + 1] = static_cast<std::int16_t>(here[u + 1] - here[u - 1]);
      out[4 * u + 2] = static_cast<std::int16_t>(below[u] - above[u]);
      out[4 * u + 3] = 0;
    }
    out[4 * (width_ - 1)] = here[width_ - 1];
  });
}

}  // namespace tolman::direct_sparse
