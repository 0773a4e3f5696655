// SPDX-License-Identifier: BSD-3-Clause
#include "pixel_warp.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "tolman/context.hpp"

namespace tolman::town {
namespace {

constexpr std::size_t kAcross = 4;  // half periods 0 to 3
constexpr std::size_t kDown = 3;

/// cos(pi k (i + 0.5) / size): without a mean over the image for k > 0.
std::vector<double> cosines(std::size_t half_periods, int size) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i) {
    values.push_back(
        std::cos(std::numbers::pi * static_cast<double>(half_periods) * (i + 0.5) / size));
  }
  return values;
}

std::vector<double> waves(int width, int height, RandomStream& random) {
  std::vector<double> field(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t n = 0; n < kDown; ++n) {
    for (std::size_t m = 0; m < kAcross; ++m) {
      if (m + n == 0) continue;
      const double amplitude = random.uniform(-1, 1) / static_cast<double>(m * m + n * n);
      const std::vector<double> across = cosines(m, width);
      const std::vector<double> down = cosines(n, height);
      std::size_t at = 0;
      for (const double row : down) {
        for (const double column : across) field[at++] += amplitude * row * column;
      }
    }
  }
  return field;
}

}  // namespace

PixelWarp makeWarp(int width, int height, double rms_px, std::uint32_t seed) {
  if (rms_px <= 0) return {};
  RandomStream random(seed);
  const std::vector<double> x = waves(width, height, random);
  const std::vector<double> y = waves(width, height, random);
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) squares += x[i] * x[i] + y[i] * y[i];
  const double factor = rms_px / std::sqrt(squares / static_cast<double>(x.size()));
  PixelWarp warp;
  for (std::size_t i = 0; i < x.size(); ++i) {
    warp.x.push_back(static_cast<float>(factor * x[i]));
    warp.y.push_back(static_cast<float>(factor * y[i]));
  }
  return warp;
}

}  // namespace tolman::town
