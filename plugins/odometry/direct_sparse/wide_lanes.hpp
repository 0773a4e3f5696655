// SPDX-License-Identifier: BSD-3-Clause
// Hot loops that exist twice: for any x86-64, and for processors with registers of eight floats.
#pragma once

/// In front of a function: the compiler makes a second one for AVX2, the loader takes what the
/// processor can run. Both do the same operations on the same numbers (AVX2 is without fused
/// multiply-add), so the results are the same bytes everywhere.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TOLMAN_WIDE_LANES __attribute__((target_clones("avx2", "default")))
#else
#define TOLMAN_WIDE_LANES
#endif

/// For what such a function calls in its loop: becomes part of both.
#define TOLMAN_INLINE inline __attribute__((always_inline))
#define TOLMAN_INLINE_LAMBDA __attribute__((always_inline))
