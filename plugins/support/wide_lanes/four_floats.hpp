// SPDX-License-Identifier: BSD-3-Clause
// Four floats at once, by the compiler's vector extension: one register of SSE2.
#pragma once

#include <cstdint>
#include <cstring>

#include "wide_lanes.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace tolman::lanes {

using FourFloats = float __attribute__((vector_size(16)));
using FourInts = std::int32_t __attribute__((vector_size(16)));  ///< masks, too: -1 is true
using FourWords = std::uint32_t __attribute__((vector_size(16)));

TOLMAN_INLINE FourFloats loadFour(const float* p) {
  FourFloats value;
  std::memcpy(&value, p, sizeof value);
  return value;
}
TOLMAN_INLINE FourFloats four(float value) { return FourFloats{value, value, value, value}; }
/// Towards zero; for |v| < 2^31.
TOLMAN_INLINE FourInts truncated(FourFloats v) { return __builtin_convertvector(v, FourInts); }
TOLMAN_INLINE FourFloats toFloat(FourInts v) { return __builtin_convertvector(v, FourFloats); }
TOLMAN_INLINE FourWords words(FourInts v) { return reinterpret_cast<FourWords>(v); }

/// Bit i is lane i of a mask.
TOLMAN_INLINE int bits(FourInts mask) {
#if defined(__SSE2__)
  return _mm_movemask_ps(reinterpret_cast<__m128>(mask));
#else
  return (mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8);
#endif
}
/// Whether any lane of a mask is true, and whether all are.
TOLMAN_INLINE bool any(FourInts mask) { return bits(mask) != 0; }
TOLMAN_INLINE bool all(FourInts mask) { return bits(mask) == 15; }

TOLMAN_INLINE FourFloats absolute(FourFloats v) {
  return reinterpret_cast<FourFloats>(reinterpret_cast<FourWords>(v) & 0x7fffffffU);
}
TOLMAN_INLINE FourFloats smaller(FourFloats a, FourFloats b) { return a < b ? a : b; }

/// Transposes the 4x4 matrix with these rows.
TOLMAN_INLINE void transpose(FourFloats& a, FourFloats& b, FourFloats& c, FourFloats& d) {
  const FourFloats ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const FourFloats ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const FourFloats cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  const FourFloats cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
  c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

/// The sum of the lanes of one vector, and the four sums of those of `a` to `d`, in this order.
TOLMAN_INLINE float sumOf(FourFloats v) { return (v[0] + v[1]) + (v[2] + v[3]); }
TOLMAN_INLINE FourFloats sums(FourFloats a, FourFloats b, FourFloats c, FourFloats d) {
  transpose(a, b, c, d);
  return (a + b) + (c + d);
}

}  // namespace tolman::lanes
