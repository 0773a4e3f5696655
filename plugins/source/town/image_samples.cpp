// SPDX-License-Identifier: BSD-3-Clause
#include "image_samples.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <array>

namespace tolman::town {
namespace {

/// Lines of an image, rows or columns, as distances between floats.
struct Lines {
  int length;             ///< values of a line
  std::ptrdiff_t along;   ///< from one value of a line to the next
  std::ptrdiff_t across;  ///< from one line to the next
};

/// Mean over the window around each value of kLines neighbouring lines. Several at once, because
/// the sums of one wait for each other, and single columns use 4 bytes of each line of the cache.
template <int kLines>
[[gnu::always_inline]] inline void slidingMeans(const float* from, float* to, const Lines& lines,
                                                int radius) {
  std::array<double, kLines> sums{};
  const auto add = [&](int at, double sign) {
    for (int line = 0; line < kLines; ++line) {
      sums[static_cast<std::size_t>(line)] +=
          sign * static_cast<double>(from[at * lines.along + line * lines.across]);
    }
  };
  for (int i = 0; i < std::min(radius, lines.length); ++i) add(i, 1);
  for (int i = 0; i < lines.length; ++i) {
    if (i + radius < lines.length) add(i + radius, 1);
    if (i - radius > 0) add(i - radius - 1, -1);
    const int inside = std::min(i + radius, lines.length - 1) - std::max(i - radius, 0) + 1;
    for (int line = 0; line < kLines; ++line) {
      to[i * lines.along + line * lines.across] =
          static_cast<float>(sums[static_cast<std::size_t>(line)] / inside);
    }
  }
}

/// The same for all `count` lines, in groups of kLines and then one by one.
template <int kLines>
[[gnu::always_inline]] inline void meansOfAll(const float* from, float* to, const Lines& lines,
                                              int count, int radius) {
  const int groups = count / kLines;
  oneapi::tbb::parallel_for(0, groups + count % kLines, [&](int i) {
    const bool is_group = i < groups;
    const int first = is_group ? i * kLines : groups * kLines + i - groups;
    const std::ptrdiff_t at = first * lines.across;
    if (is_group) {
      slidingMeans<kLines>(from + at, to + at, lines, radius);
    } else {
      slidingMeans<1>(from + at, to + at, lines, radius);
    }
  });
}

}  // namespace

std::vector<float> boxBlur(const std::vector<float>& values, int width, int height, int radius) {
  std::vector<float> rows(values.size());
  std::vector<float> result(values.size());
  meansOfAll<4>(values.data(), rows.data(), {width, 1, width}, height, radius);
  meansOfAll<16>(rows.data(), result.data(), {height, width, 1}, width, radius);
  return result;
}

}  // namespace tolman::town
