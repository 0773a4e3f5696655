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
using EightInts = std::int32_t __attribute__((vector_size(32)));

TOLMAN_INLINE Eight loadEight(const float* p) {
  Eight value;
  std::memcpy(&value, p, sizeof value);
  return value;
}
TOLMAN_INLINE Eight toFloat(EightInts value) { return __builtin_convertvector(value, Eight); }
TOLMAN_INLINE EightInts truncated(Eight value) { return __builtin_convertvector(value, EightInts); }
TOLMAN_INLINE Eight absolute(Eight value) { return value < 0.0F ? -value : value; }
TOLMAN_INLINE Eight smaller(Eight a, Eight b) { return a < b ? a : b; }
TOLMAN_INLINE Four lowHalf(Eight v) { return __builtin_shufflevector(v, v, 0, 1, 2, 3); }
TOLMAN_INLINE Four highHalf(Eight v) { return __builtin_shufflevector(v, v, 4, 5, 6, 7); }
TOLMAN_INLINE Eight joined(Four low, Four high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
TOLMAN_INLINE bool all(EightInts mask) {
  return all(FourInts(__builtin_shufflevector(mask, mask, 0, 1, 2, 3) &
                      __builtin_shufflevector(mask, mask, 4, 5, 6, 7)));
}

}  // namespace tolman::direct_sparse
