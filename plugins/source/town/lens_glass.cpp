// SPDX-License-Identifier: BSD-3-Clause
#include "lens_glass.hpp"

#include <algorithm>
#include <cmath>

#include "image_samples.hpp"
#include "noise.hpp"

namespace tolman::town {
namespace {

// All chosen, not tuned.
constexpr float kSpot = 70;         ///< px at scale 1, wavelength of dirt
constexpr float kSoft = 0.35F;      ///< range of the noise over which a spot fades out
constexpr float kDims = 0.55F;      ///< share of light that dirt absorbs
constexpr float kScatters = 0.2F;   ///< share of the veil that dirt adds
constexpr float kSmallest = 7;      ///< px at scale 1, radius of drops
constexpr float kLargest = 38;      ///< px
constexpr float kRefraction = 3.5;  ///< a drop shows this many times its width, inverted

std::vector<float> dirtMask(const GlassSize& size, double share, std::uint32_t seed) {
  if (share <= 0) return {};
  std::vector<float> mask;
  const float wavelength = kSpot * static_cast<float>(size.scale);
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
      mask.push_back(
          fractal2(static_cast<float>(column), static_cast<float>(row), wavelength, 3, 1, seed));
    }
  }
  std::vector<float> sorted = mask;
  const auto clean = static_cast<std::ptrdiff_t>((1 - share) * static_cast<double>(sorted.size()));
  std::nth_element(sorted.begin(), sorted.begin() + clean, sorted.end());
  const float limit = sorted[static_cast<std::size_t>(clean)];
  for (float& value : mask) value = smoothstep(limit, limit + kSoft, value);
  return mask;
}

}  // namespace

struct LensGlass::Drop {
  float u, v;    // px, its centre
  float radius;  // px
};

LensGlass::LensGlass(const GlassSize& size, double dirt, double drops, std::uint32_t seed)
    : size_(size),
      dirt_(dirtMask(size, dirt, seed)),
      drops_(static_cast<std::uint32_t>(std::lround(drops))),
      seed_(seed) {}

LensGlass::Drop LensGlass::dropAt(std::uint32_t number, double seconds) const {
  const double life = static_cast<double>(between(hash(seed_, number, 1), 2, 8));
  const double phase = life * static_cast<double>(unit(hash(seed_, number, 2)));
  const auto generation = static_cast<std::uint32_t>((seconds + phase) / life);
  const std::uint32_t own = hash(seed_, number, generation + 16);
  const float size = kSmallest * std::pow(kLargest / kSmallest, unit(hash(own, 3)));
  return {unit(hash(own, 1)) * static_cast<float>(size_.width),
          unit(hash(own, 2)) * static_cast<float>(size_.height),
          size * static_cast<float>(size_.scale)};
}

void LensGlass::refract(std::vector<float>& radiance, double seconds) const {
  const int haze = std::max(1, static_cast<int>(std::lround(5 * size_.scale)));
  const std::vector<float> dim = boxBlur(radiance, size_.width, size_.height, haze);
  const ImageSamples behind{dim, size_.width, size_.height};
  for (std::uint32_t i = 0; i < drops_; ++i) {
    const Drop drop = dropAt(i, seconds);
    const auto reach = static_cast<int>(std::ceil(drop.radius));
    const auto u = static_cast<int>(drop.u);
    const auto v = static_cast<int>(drop.v);
    for (int r = std::max(v - reach, 0); r <= std::min(v + reach, size_.height - 1); ++r) {
      for (int c = std::max(u - reach, 0); c <= std::min(u + reach, size_.width - 1); ++c) {
        const float du = static_cast<float>(c) - drop.u;
        const float dv = static_cast<float>(r) - drop.v;
        const float outwards = std::sqrt(du * du + dv * dv) / drop.radius;
        const float cover = 1 - smoothstep(0.7F, 1, outwards);
        if (cover <= 0) continue;
        const float inverted = behind.at(drop.u - kRefraction * du, drop.v - kRefraction * dv);
        const float rim = 1 - 0.4F * smoothstep(0.4F, 0.9F, outwards);
        float& value = radiance[behind.index(c, r)];
        value += cover * (rim * inverted - value);
      }
    }
  }
}

void LensGlass::apply(std::vector<float>& radiance, float veil, double seconds) const {
  if (drops_ > 0) refract(radiance, seconds);
  for (std::size_t i = 0; i < dirt_.size(); ++i) {
    radiance[i] += dirt_[i] * (kScatters * veil - kDims * radiance[i]);
  }
}

}  // namespace tolman::town
