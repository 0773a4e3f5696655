// SPDX-License-Identifier: BSD-3-Clause
// TOLMAN_TOWN_DISPATCH before a function: it is compiled twice, and the version is chosen when the
// library is loaded. Both give the same bytes, because AVX2 without FMA fuses no operations.
#pragma once

// Not with sanitizers, which are not yet initialised then.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define TOLMAN_TOWN_DISPATCH __attribute__((target_clones("avx2", "default")))
#else
#define TOLMAN_TOWN_DISPATCH
#endif
