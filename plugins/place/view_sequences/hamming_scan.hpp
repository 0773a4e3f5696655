// SPDX-License-Identifier: BSD-3-Clause
// Counts the differing bits between a few codes and all stored ones: the part of the search whose
// time is proportional to the number of stored views.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tolman::view_sequences {

inline constexpr int kCodeBits = 256;  // a million are scanned in 1.9 ms, of 512 bits in 12.6 ms
using PlaceCode = std::array<std::uint64_t, kCodeBits / 64>;

/// Codes of the present view, one for each tried shift.
inline constexpr int kTriedShifts = 3;
using CodeQueries = std::array<PlaceCode, kTriedShifts>;

/// Writes for each of `count` codes the smallest number of bits in which it differs from a query.
using HammingScan = void (*)(const PlaceCode* codes, std::int64_t count, const CodeQueries& queries,
                             std::uint16_t* bits);

/// The versions that this processor supports, the fastest first; all give the same numbers.
std::vector<HammingScan> hammingScans();

}  // namespace tolman::view_sequences
