// SPDX-License-Identifier: BSD-3-Clause
#include "bloom.hpp"

#include <algorithm>
#include <cmath>

#include "image_samples.hpp"

namespace tolman::town {
namespace {

/// A box filter applied twice, which is a tent filter without the hard edges of a box.
std::vector<float> halo(const std::vector<float>& light, int width, int height, double radius) {
  const int pixels = std::max(1, static_cast<int>(std::lround(radius)));
  return boxBlur(boxBlur(light, width, height, pixels), width, height, pixels);
}

}  // namespace

void addBloom(std::vector<float>& radiance, int width, int height, float saturation, float bloom,
              double scale) {
  constexpr float kMaxExcess = 100;  // in units of saturation; chosen, not tuned
  std::vector<float> excess(radiance.size());
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    excess[i] = std::clamp(radiance[i] - saturation, 0.0F, kMaxExcess * saturation);
  }
  // Radii in px at scale 1, and their equal shares: chosen, not tuned.
  const std::vector<float> narrow = halo(excess, width, height, 4 * scale);
  const std::vector<float> wide = halo(excess, width, height, 40 * scale);
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    radiance[i] += 0.5F * bloom * (narrow[i] + wide[i]);
  }
}

}  // namespace tolman::town
