// SPDX-License-Identifier: BSD-3-Clause
// Four doubles at once, for functions marked TOLMAN_WIDE_LANES: one register of AVX2, two of
// SSE2. Only pass them to functions that are inlined into the caller (see eight_floats.hpp).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "wide_lanes.hpp"

namespace tolman::lanes {

using FourDoubles = double __attribute__((vector_size(32)));
using FourMask = std::int64_t __attribute__((vector_size(32)));  ///< -1 is true

/// `count` vectors, aligned to 32 bytes. Code for AVX2 expects that alignment, while the type of
/// the vectors alone demands 16 where the compiler's default is SSE2. So keep vectors in this type,
/// and declare single ones after members of this type.
template <std::size_t count>
struct alignas(32) Fours {
  FourDoubles values[count];

  TOLMAN_INLINE FourDoubles& operator[](std::size_t i) { return values[i]; }
  TOLMAN_INLINE const FourDoubles& operator[](std::size_t i) const { return values[i]; }
};

TOLMAN_INLINE FourDoubles four(double value) { return FourDoubles{value, value, value, value}; }
TOLMAN_INLINE FourDoubles select(FourMask mask, FourDoubles a, FourDoubles b) {
  return mask ? a : b;
}
TOLMAN_INLINE FourDoubles squareRoot(FourDoubles v) {
  return FourDoubles{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
}
TOLMAN_INLINE double sumOf(FourDoubles v) { return (v[0] + v[1]) + (v[2] + v[3]); }

}  // namespace tolman::lanes
