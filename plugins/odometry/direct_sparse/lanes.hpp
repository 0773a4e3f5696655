// SPDX-License-Identifier: BSD-3-Clause
// Four and eight pixels at once, by the vectors of plugins/support/wide_lanes.
#pragma once

#include "eight_floats.hpp"

namespace tolman::direct_sparse {

using namespace lanes;
using Four = FourFloats;
using Eight = EightFloats;

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

/// Eight bytes, as floats.
TOLMAN_INLINE Eight eightBytes(const std::uint8_t* p) {
  return joined(loadBytes(p), loadBytes(p + 4));
}
/// a[i] - b[i], as floats.
TOLMAN_INLINE Eight differences(const std::uint8_t* a, const std::uint8_t* b) {
#if defined(__SSE2__)
  using EightShorts = std::int16_t __attribute__((vector_size(16)));
  const auto shorts = [](const std::uint8_t* p) TOLMAN_INLINE_LAMBDA {
    return _mm_unpacklo_epi8(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p)),
                             _mm_setzero_si128());
  };
  const auto wide = reinterpret_cast<EightShorts>(_mm_sub_epi16(shorts(a), shorts(b)));
  return toFloat(__builtin_convertvector(wide, EightInts));
#else
  return eightBytes(a) - eightBytes(b);
#endif
}

}  // namespace tolman::direct_sparse
