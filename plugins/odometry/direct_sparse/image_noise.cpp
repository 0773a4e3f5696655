// SPDX-License-Identifier: BSD-3-Clause
// Quartile of second differences, and a binomial filter in whole numbers.
#include "image_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace tolman::direct_sparse {
namespace {

// Lower quartile of the size of a normally distributed number of standard deviation 1.
constexpr double kNormalQuartile = 0.3186;
// Root of the sum of the squared weights 1 -2 1, -2 4 -2, 1 -2 1 of a difference.
constexpr double kDifferenceGain = 6;
constexpr std::size_t kSizes = 512;  // larger differences are not noise

using Histogram = std::array<int, kSizes>;

/// Sizes of the second differences on a grid, without black and saturated pixels, which hide noise.
Histogram differences(const GrayLevel& image) {
  constexpr int kStep = 3;  // px; differences do not overlap
  Histogram sizes{};
  for (int v = 1; v + 1 < image.height; v += kStep) {
    const std::uint8_t* a = image.row(v - 1);
    const std::uint8_t* b = image.row(v);
    const std::uint8_t* c = image.row(v + 1);
    for (int u = 1; u + 1 < image.width; u += kStep) {
      if (b[u] == 0 || b[u] == 255) continue;
      const int corners = a[u - 1] + a[u + 1] + c[u - 1] + c[u + 1];
      const int sides = a[u] + c[u] + b[u - 1] + b[u + 1];
      const auto size = static_cast<std::size_t>(std::abs(corners - 2 * sides + 4 * b[u]));
      ++sizes[std::min(size, kSizes - 1)];
    }
  }
  return sizes;
}

}  // namespace

float imageNoise(const GrayLevel& image) {
  const Histogram sizes = differences(image);
  int count = 0;
  for (const int n : sizes) count += n;
  double missing = 0.25 * count;
  for (std::size_t size = 0; size < sizes.size(); ++size) {
    if (missing < sizes[size]) {
      // Differences were rounded: those of one size are spread over half a level to both sides.
      const double within = missing / sizes[size];
      const double quartile = size == 0 ? 0.5 * within : static_cast<double>(size) - 0.5 + within;
      return static_cast<float>(quartile / (kNormalQuartile * kDifferenceGain));
    }
    missing -= sizes[size];
  }
  return 0;
}

float smoothedShare(float noise) {
  // Grey levels. Images of KITTI and of the town by day have 1.2 to 2.3 and are not changed,
  // because smoothing costs accuracy there; by night the town has 4 to 5. Chosen on the town along
  // KITTI 06.
  constexpr float kQuiet = 2.5F;
  constexpr float kNoisy = 4;
  return std::clamp((noise - kQuiet) / (kNoisy - kQuiet), 0.0F, 1.0F);
}

void smooth(GrayLevel& image, float share, std::vector<std::uint8_t>& before) {
  const int weight = static_cast<int>(256 * share);
  if (weight == 0 || image.width == 0) return;
  before = image.pixels;
  const auto row = [&](int v) {
    const auto inside = static_cast<std::ptrdiff_t>(std::clamp(v, 0, image.height - 1));
    return before.data() + inside * image.width;
  };
  const int last = image.width - 1;
  for (int v = 0; v < image.height; ++v) {
    const std::uint8_t* a = row(v - 1);
    const std::uint8_t* b = row(v);
    const std::uint8_t* c = row(v + 1);
    std::uint8_t* out = image.row(v);
    const auto mix = [&](int left, int u, int right) {
      const int corners = a[left] + a[right] + c[left] + c[right];
      const int sides = a[u] + c[u] + b[left] + b[right];
      const int mean = corners + 2 * sides + 4 * b[u];  // sixteenfold
      const int mixed = weight * mean + 16 * (256 - weight) * b[u];
      out[u] = static_cast<std::uint8_t>((mixed + 2048) >> 12);
    };
    mix(0, 0, std::min(1, last));
    for (int u = 1; u < last; ++u) mix(u - 1, u, u + 1);
    if (last > 0) mix(last - 1, last, last);
  }
}

}  // namespace tolman::direct_sparse
