// SPDX-License-Identifier: BSD-3-Clause
// The residual pattern of a point, eight pixels, and the weights of its residuals (Engel et al.,
// PAMI 2018, section 2.2, figure 4 and equation 7). The constants are those of the paper.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "lanes.hpp"
#include "pyramid.hpp"

namespace tolman::direct_sparse {

inline constexpr int kPatternSize = 8;
inline constexpr int kPatternRadius = 2;  // px
inline constexpr std::array<int, kPatternSize> kPatternU = {0, -1, 1, -2, 0, 2, -1, 0};
inline constexpr std::array<int, kPatternSize> kPatternV = {-2, -1, -1, 0, 0, 0, 1, 2};

inline constexpr float kHuber = 9;                 // grey levels
inline constexpr float kGradientConstant2 = 2500;  // c^2 of the gradient weight

/// Weight omega (equation 7): less weight for strong gradients, where geometric errors matter most.
inline float gradientWeight(float squared_gradient) {
  return kGradientConstant2 / (kGradientConstant2 + squared_gradient);
}

/// Weight of the Huber norm.
inline float huberWeight(float residual) {
  const float size = std::fabs(residual);
  return size <= kHuber ? 1.0F : kHuber / size;
}

/// Twice the Huber norm: the square for small residuals. `weight` is huberWeight(residual).
inline float huberEnergy(float residual, float weight) {
  return weight * (2.0F - weight) * residual * residual;
}

// Grey values and gradients (central differences), computed from the bytes of an image where they
// are needed. An image of gradients would be eight times as large, and residuals, which read all
// keyframes at random places, would wait for memory most of their time.

/// I(u+1, v) - I(u-1, v) and I(u, v+1) - I(u, v-1): twice the gradient, grey levels / px. The pixel
/// must not be an outermost one.
struct Differences {
  int gu = 0;
  int gv = 0;
};
inline Differences differencesAt(const GrayLevel& image, int u, int v) {
  const std::uint8_t* p = image.row(v) + u;
  return {p[1] - p[-1], p[image.width] - p[-image.width]};
}

/// Squared gradient at a pixel, (grey levels / px)^2; not at an outermost one.
inline float gradientSquared(const GrayLevel& image, int u, int v) {
  const Differences d = differencesAt(image, u, v);
  return 0.25F * static_cast<float>(d.gu * d.gu + d.gv * d.gv);
}

/// Four neighbouring bytes of one image row, for each of eight places.
struct RowBytes {
  EightInts word;

  template <int kByte>
  TOLMAN_INLINE Eight at() const {
    return toFloat(word >> (8 * kByte) & 255);
  }
};

/// The bytes at `pixels` + place, for each of eight places.
TOLMAN_INLINE RowBytes rowBytes(const std::uint8_t* pixels,
                                const std::array<std::int32_t, 8>& places) {
  const auto word = [&](std::size_t k) TOLMAN_INLINE_LAMBDA {
    std::int32_t bytes = 0;
    std::memcpy(&bytes, pixels + places[k], sizeof bytes);
    return bytes;
  };
  return {EightInts{word(0), word(1), word(2), word(3), word(4), word(5), word(6), word(7)}};
}

/// Grey levels at eight places; (u, v) must lie in [0, width - 1) x [0, height - 1). The same as
/// GrayLevel::at(). Reads two bytes more of each row.
TOLMAN_INLINE Eight bilinear(const GrayLevel& image, Eight u, Eight v) {
  const EightInts column = truncated(u);
  const EightInts row = truncated(v);
  const EightInts pixel = row * image.width + column;
  std::array<std::int32_t, 8> places;  // NOLINT: written before it is read
  for (std::size_t k = 0; k < places.size(); ++k) places[k] = pixel[k];
  const RowBytes above = rowBytes(image.row(0), places);
  const RowBytes below = rowBytes(image.row(1), places);
  const Eight fx = u - toFloat(column);
  const Eight fy = v - toFloat(row);
  const Eight top = above.at<0>() + fx * (above.at<1>() - above.at<0>());
  const Eight bottom = below.at<0>() + fx * (below.at<1>() - below.at<0>());
  return top + fy * (bottom - top);
}

/// Values (grey levels) and gradients (grey levels / px) at eight places.
struct GradientSamples {
  Eight value;
  Eight gx;
  Eight gy;
};

/// Places are rounded to 1 / kMixOne of a pixel along each axis. All numbers before the final
/// scaling are then whole and below 2^24, so sums in float are exact.
inline constexpr float kMixOne = 128;

/// Bilinear; (u, v) must lie in [1, width - 2) x [1, height - 2).
TOLMAN_INLINE GradientSamples gradientSamples(const GrayLevel& image, Eight u, Eight v) {
  const EightInts x = truncated(u);
  const EightInts y = truncated(v);
  const Eight right = toFloat(truncated((u - toFloat(x)) * kMixOne + 0.5F));
  const Eight below = toFloat(truncated((v - toFloat(y)) * kMixOne + 0.5F));
  const Eight left = kMixOne - right;
  const Eight above = kMixOne - below;
  const EightInts first = (y - 1) * image.width + (x - 1);
  std::array<std::int32_t, 8> places;  // NOLINT: written before it is read
  for (std::size_t k = 0; k < places.size(); ++k) places[k] = first[k];
  const auto row = [&](int v_offset)
                       TOLMAN_INLINE_LAMBDA { return rowBytes(image.row(v_offset), places); };
  const auto value = [&](const RowBytes& bytes) TOLMAN_INLINE_LAMBDA {
    return left * bytes.at<1>() + right * bytes.at<2>();
  };
  const auto slope = [&](const RowBytes& bytes) TOLMAN_INLINE_LAMBDA {
    return left * (bytes.at<2>() - bytes.at<0>()) + right * (bytes.at<3>() - bytes.at<1>());
  };
  const RowBytes upper = row(1);
  const RowBytes lower = row(2);
  const Eight upper_value = value(upper);
  const Eight lower_value = value(lower);
  const Eight upper_gy = lower_value - value(row(0));
  const Eight lower_gy = value(row(3)) - upper_value;
  constexpr float kScale = 1 / (kMixOne * kMixOne);
  return {kScale * (above * upper_value + below * lower_value),
          0.5F * kScale * (above * slope(upper) + below * slope(lower)),
          0.5F * kScale * (above * upper_gy + below * lower_gy)};
}

}  // namespace tolman::direct_sparse
