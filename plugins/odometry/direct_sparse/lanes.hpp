// SPDX-License-Identifier: BSD-3-Clause
// Four and eight pixels at once, by the vectors of plugins/support/wide_lanes.
#pragma once

#include "eight_floats.hpp"

namespace tolman::direct_sparse {

using namespace lanes;
using Four = FourFloats;
using Eight = EightFloats;

/// Bilinear weights are multiples of 1/128 along each axis, so their products are whole numbers.
inline constexpr int kMixOne = 128;

/// Weighted mean of two horizontal neighbours of four 16-bit numbers each, in two rows. The weight
/// of the left one is in the lower 16 bits of `top` and `bottom`, that of the right one in the
/// upper; all four weights sum to kMixOne^2.
inline Four mixShorts(const std::int16_t* top, const std::int16_t* bottom, std::int32_t top_weights,
                      std::int32_t bottom_weights) {
  constexpr float kScale = 1.0F / (kMixOne * kMixOne);
#if defined(__SSE2__)
  const auto row = [](const std::int16_t* p, std::int32_t weights) {
    const __m128i both = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
    const __m128i pairs = _mm_unpacklo_epi16(both, _mm_srli_si128(both, 8));
    return _mm_madd_epi16(pairs, _mm_set1_epi32(weights));
  };
  const __m128i sum = _mm_add_epi32(row(top, top_weights), row(bottom, bottom_weights));
  return kScale * static_cast<Four>(_mm_cvtepi32_ps(sum));
#else
  FourInts sum = {};
  for (int i = 0; i < 4; ++i) {
    sum[i] = (top_weights & 0xFFFF) * top[i] + (top_weights >> 16) * top[i + 4] +
             (bottom_weights & 0xFFFF) * bottom[i] + (bottom_weights >> 16) * bottom[i + 4];
  }
  return kScale * toFloat(sum);
#endif
}

/// The same at a fraction (fx, fy) between the neighbours.
inline Four mixShorts(const std::int16_t* top, const std::int16_t* bottom, float fx, float fy) {
  const int x = static_cast<int>(fx * kMixOne + 0.5F);
  const int y = static_cast<int>(fy * kMixOne + 0.5F);
  const int right = x * y;
  const int left = kMixOne * y - right;
  return mixShorts(top, bottom,
                   (kMixOne * (kMixOne - y) - kMixOne * x + right) | (kMixOne * x - right) << 16,
                   left | right << 16);
}

/// Four bytes, as floats.
inline Four loadBytes(const std::uint8_t* p) {
#if defined(__SSE2__)
  std::int32_t bytes = 0;
  std::memcpy(&bytes, p, sizeof bytes);
  const __m128i zero = _mm_setzero_si128();
  const __m128i shorts = _mm_unpacklo_epi8(_mm_cvtsi32_si128(bytes), zero);
  return _mm_cvtepi32_ps(_mm_unpacklo_epi16(shorts, zero));
#else
  return Four{float(p[0]), float(p[1]), float(p[2]), float(p[3])};
#endif
}

}  // namespace tolman::direct_sparse
