// SPDX-License-Identifier: BSD-3-Clause
// Eight floats at once, for functions marked TOLMAN_WIDE_LANES: one register of AVX2, two of
// SSE2. Whether such values pass between functions in registers depends on the processor that the
// caller is compiled for, so only pass them to functions that are inlined into the caller.
#pragma once

#include <array>
#include <cmath>

#include "four_floats.hpp"

namespace tolman::lanes {

using EightFloats = float __attribute__((vector_size(32)));
using EightInts = std::int32_t __attribute__((vector_size(32)));  ///< masks, too: -1 is true
using EightWords = std::uint32_t __attribute__((vector_size(32)));

TOLMAN_INLINE EightFloats eight(float value) { return value - EightFloats{}; }
TOLMAN_INLINE EightFloats loadEight(const float* p) {
  EightFloats value;
  std::memcpy(&value, p, sizeof value);
  return value;
}
TOLMAN_INLINE void store(EightFloats value, float* p) { std::memcpy(p, &value, sizeof value); }
/// Towards zero; for |v| < 2^31.
TOLMAN_INLINE EightInts truncated(EightFloats v) { return __builtin_convertvector(v, EightInts); }
TOLMAN_INLINE EightFloats toFloat(EightInts v) { return __builtin_convertvector(v, EightFloats); }
TOLMAN_INLINE EightWords words(EightInts v) { return reinterpret_cast<EightWords>(v); }

TOLMAN_INLINE FourFloats lowHalf(EightFloats v) {
  return __builtin_shufflevector(v, v, 0, 1, 2, 3);
}
TOLMAN_INLINE FourFloats highHalf(EightFloats v) {
  return __builtin_shufflevector(v, v, 4, 5, 6, 7);
}
TOLMAN_INLINE EightFloats joined(FourFloats low, FourFloats high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

/// Whether any lane of a mask is true, and whether all are.
TOLMAN_INLINE bool any(EightInts mask) {
  return any(FourInts(__builtin_shufflevector(mask, mask, 0, 1, 2, 3) |
                      __builtin_shufflevector(mask, mask, 4, 5, 6, 7)));
}
TOLMAN_INLINE bool all(EightInts mask) {
  return all(FourInts(__builtin_shufflevector(mask, mask, 0, 1, 2, 3) &
                      __builtin_shufflevector(mask, mask, 4, 5, 6, 7)));
}

// Written so that one instruction of SSE computes each.
TOLMAN_INLINE EightFloats larger(EightFloats a, EightFloats b) { return a > b ? a : b; }
TOLMAN_INLINE EightFloats smaller(EightFloats a, EightFloats b) { return a < b ? a : b; }
TOLMAN_INLINE EightFloats larger(EightFloats a, float b) { return larger(a, eight(b)); }
TOLMAN_INLINE EightFloats smaller(EightFloats a, float b) { return smaller(a, eight(b)); }
TOLMAN_INLINE EightFloats clamped(EightFloats v, float low, float high) {
  return smaller(larger(v, low), high);
}
TOLMAN_INLINE EightFloats absolute(EightFloats v) {
  return reinterpret_cast<EightFloats>(reinterpret_cast<EightWords>(v) & 0x7fffffffU);
}
TOLMAN_INLINE EightFloats select(EightInts mask, EightFloats a, EightFloats b) {
  return mask ? a : b;
}
TOLMAN_INLINE EightFloats select(EightInts mask, float a, float b) {
  return mask ? eight(a) : eight(b);
}

/// Masks from signs, and selection by bit operations: where a register has only four lanes, the
/// compiler would split `a < b` and `mask ? a : b` of eight into single lanes.
TOLMAN_INLINE EightInts negative(EightInts value) { return value >> 31; }
TOLMAN_INLINE EightInts negative(EightFloats value) {
  return negative(reinterpret_cast<EightInts>(value));
}
/// a where the mask is set, b elsewhere.
TOLMAN_INLINE EightInts chosen(EightInts mask, EightInts a, EightInts b) {
  return (mask & a) | (~mask & b);
}
TOLMAN_INLINE EightFloats chosen(EightInts mask, EightFloats a, EightFloats b) {
  return reinterpret_cast<EightFloats>(
      chosen(mask, reinterpret_cast<EightInts>(a), reinterpret_cast<EightInts>(b)));
}

/// A loop over memory, because the vector extension has no square root.
TOLMAN_INLINE EightFloats squareRoot(EightFloats v) {
  alignas(32) std::array<float, 8> lanes;
  std::memcpy(lanes.data(), &v, sizeof v);
  for (float& lane : lanes) lane = std::sqrt(lane);
  std::memcpy(&v, lanes.data(), sizeof v);
  return v;
}

/// Correct for |x| < 2^31.
TOLMAN_INLINE EightFloats floorOf(EightFloats x) {
  const EightFloats t = toFloat(truncated(x));
  return t > x ? t - 1 : t;
}

}  // namespace tolman::lanes
