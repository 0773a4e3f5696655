// SPDX-License-Identifier: BSD-3-Clause
// Marks inner loops that are compiled twice: for any x86-64, and for processors with AVX2. The only
// place where code is chosen between these two; for vectors of numbers in such loops see
// four_floats.hpp, eight_floats.hpp and four_doubles.hpp.
#pragma once

/// Put before a function: the compiler generates a second version for AVX2, and the loader chooses.
/// Both do the same operations in the same order (no fused multiply-add), so results are identical.
/// Empty with sanitizers, which are not yet initialised when the loader chooses.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TOLMAN_WIDE_LANES __attribute__((target_clones("avx2", "default")))
#else
#define TOLMAN_WIDE_LANES
#endif

/// For functions that such a loop calls: inlined into both versions.
#define TOLMAN_INLINE inline __attribute__((always_inline))
#define TOLMAN_INLINE_LAMBDA __attribute__((always_inline))
