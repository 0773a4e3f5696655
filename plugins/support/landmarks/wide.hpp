// SPDX-License-Identifier: BSD-3-Clause
// Marks loops that are compiled twice, and the faster version chosen when the plugin is loaded.
// Both give the same bytes: sums have the same order, and there is no fused multiply-add.
#pragma once

// Not with sanitizers, which are not yet initialised when the loader chooses.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TOLMAN_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define TOLMAN_WIDE
#endif
