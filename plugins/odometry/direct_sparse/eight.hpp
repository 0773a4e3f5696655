// SPDX-License-Identifier: BSD-3-Clause
// Eight floats at once, for functions that are TOLMAN_WIDE_LANES: one register of AVX2, two of
// SSE2. Whether such values pass between functions in registers depends on the processor that the
// caller is compiled for, so only pass them to functions that are inlined into the caller.
#pragma once

#include <cstdint>
#include <cstring>

#include "four.hpp"
#include "wide_lanes.hpp"

namespace tolman::direct_sparse {

using Eight = float __attribute__((vector_size(32)));
using EightShorts = std::int16_t __attribute__((vector_size(16)));
using EightInts = std::int32_t __attribute__((vector_size(32)));

TOLMAN_INLINE Eight loadEight(const float* p) {
  Eight value;
  std::memcpy(&value, p, sizeof value);
  return value;
}
TOLMAN_INLINE void storeEight(Eight value, float* p) { std::memcpy(p, &value, sizeof value); }
TOLMAN_INLINE Eight toFloat(EightInts value) { return __builtin_convertvector(value, Eight); }
TOLMAN_INLINE EightInts truncated(Eight value) { return __builtin_convertvector(value, EightInts); }
TOLMAN_INLINE Eight absolute(Eight value) { return value < 0.0F ? -value : value; }
TOLMAN_INLINE Eight smaller(Eight a, Eight b) { return a < b ? a : b; }
/// Masks from signs and choices by bits: where a register has only four lanes, the compiler would
/// split `a < b` and `mask ? a : b` of eight into single lanes.
TOLMAN_INLINE EightInts negative(EightInts value) { return value >> 31; }
TOLMAN_INLINE EightInts negative(Eight value) {
  return negative(reinterpret_cast<EightInts>(value));
}
/// a where the mask is set, b elsewhere.
TOLMAN_INLINE EightInts chosen(EightInts mask, EightInts a, EightInts b) {
  return (mask & a) | (~mask & b);
}
TOLMAN_INLINE Eight chosen(EightInts mask, Eight a, Eight b) {
  return reinterpret_cast<Eight>(
      chosen(mask, reinterpret_cast<EightInts>(a), reinterpret_cast<EightInts>(b)));
}
TOLMAN_INLINE Four lowHalf(Eight v) { return __builtin_shufflevector(v, v, 0, 1, 2, 3); }
TOLMAN_INLINE Four highHalf(Eight v) { return __builtin_shufflevector(v, v, 4, 5, 6, 7); }
TOLMAN_INLINE Eight joined(Four low, Four high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
/// Eight bytes, as floats.
TOLMAN_INLINE Eight eightBytes(const std::uint8_t* p) {
  return joined(loadBytes(p), loadBytes(p + 4));
}
/// a[i] - b[i], as floats.
TOLMAN_INLINE Eight differences(const std::uint8_t* a, const std::uint8_t* b) {
#if defined(__SSE2__)
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
TOLMAN_INLINE bool all(EightInts mask) {
  return all(FourInts(__builtin_shufflevector(mask, mask, 0, 1, 2, 3) &
                      __builtin_shufflevector(mask, mask, 4, 5, 6, 7)));
}

}  // namespace tolman::direct_sparse
