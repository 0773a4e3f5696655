// SPDX-License-Identifier: BSD-3-Clause
// Four floats at once, by the compiler's vector extension: SSE2 on x86-64.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace tolman::direct_sparse {

using Four = float __attribute__((vector_size(16)));
using FourInts = std::int32_t __attribute__((vector_size(16)));

inline Four loadFour(const float* p) {
  Four value;
  std::memcpy(&value, p, sizeof value);
  return value;
}
inline Four four(float value) { return Four{value, value, value, value}; }
inline FourInts truncated(Four value) { return __builtin_convertvector(value, FourInts); }
inline Four toFloat(FourInts value) { return __builtin_convertvector(value, Four); }
/// Whether a comparison holds in all lanes.
inline bool all(FourInts mask) {
#if defined(__SSE2__)
  return _mm_movemask_ps(reinterpret_cast<__m128>(mask)) == 15;
#else
  return (mask[0] & mask[1] & mask[2] & mask[3]) != 0;
#endif
}
inline Four absolute(Four value) { return value < 0.0F ? -value : value; }
inline Four smaller(Four a, Four b) { return a < b ? a : b; }

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

/// Transposes the 4x4 matrix with these rows.
inline void transpose(Four& a, Four& b, Four& c, Four& d) {
  const Four ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Four ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Four cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  const Four cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
  c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

/// The sum of the lanes of each argument, in order.
inline Four sums(Four a, Four b, Four c, Four d) {
  transpose(a, b, c, d);
  return (a + b) + (c + d);
}

}  // namespace tolman::direct_sparse
