// SPDX-License-Identifier: BSD-3-Clause
#include "image_samples.hpp"

#include <oneapi/tbb/parallel_for.h>

namespace tolman::town {
namespace {

/// Mean over the window around each of `count` values, which are `stride` elements apart.
void slidingMean(const float* from, float* to, int count, std::ptrdiff_t stride, int radius) {
  double sum = 0;
  for (int i = 0; i < std::min(radius, count); ++i) sum += static_cast<double>(from[i * stride]);
  for (int i = 0; i < count; ++i) {
    if (i + radius < count) sum += static_cast<double>(from[(i + radius) * stride]);
    if (i - radius > 0) sum -= static_cast<double>(from[(i - radius - 1) * stride]);
    const int inside = std::min(i + radius, count - 1) - std::max(i - radius, 0) + 1;
    to[i * stride] = static_cast<float>(sum / inside);
  }
}

}  // namespace

std::vector<float> boxBlur(const std::vector<float>& values, int width, int height, int radius) {
  std::vector<float> rows(values.size());
  std::vector<float> result(values.size());
  oneapi::tbb::parallel_for(0, height, [&](int row) {
    const std::ptrdiff_t at = std::ptrdiff_t{row} * width;
    slidingMean(values.data() + at, rows.data() + at, width, 1, radius);
  });
  oneapi::tbb::parallel_for(0, width, [&](int column) {
    slidingMean(rows.data() + column, result.data() + column, height, width, radius);
  });
  return result;
}

}  // namespace tolman::town
