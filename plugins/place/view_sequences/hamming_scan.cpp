// SPDX-License-Identifier: BSD-3-Clause
#include "hamming_scan.hpp"

namespace tolman::view_sequences {
namespace {

[[gnu::always_inline]] inline void scan(const PlaceCode* codes, std::int64_t count,
                                        const CodeQueries& queries, std::uint16_t* bits) {
  for (std::int64_t i = 0; i < count; ++i) {
    int least = kCodeBits;
    for (const PlaceCode& query : queries) {
      int differing = 0;
      for (std::size_t w = 0; w < query.size(); ++w) {
        differing += __builtin_popcountll(codes[i][w] ^ query[w]);
      }
      least = differing < least ? differing : least;
    }
    bits[i] = static_cast<std::uint16_t>(least);
  }
}

void scanPortably(const PlaceCode* codes, std::int64_t count, const CodeQueries& queries,
                  std::uint16_t* bits) {
  scan(codes, count, queries, bits);
}

#ifdef __x86_64__

/// One instruction counts the bits of a word.
[[gnu::target("popcnt")]] void scanWords(const PlaceCode* codes, std::int64_t count,
                                         const CodeQueries& queries, std::uint16_t* bits) {
  scan(codes, count, queries, bits);
}

/// One instruction counts the bits of several words.
[[gnu::target("avx512vpopcntdq,avx512vl,avx512bw,avx512dq")]] void scanVectors(
    const PlaceCode* codes, std::int64_t count, const CodeQueries& queries, std::uint16_t* bits) {
  scan(codes, count, queries, bits);
}

bool hasVectorCounts() {
  return __builtin_cpu_supports("avx512vpopcntdq") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq");
}

#endif

}  // namespace

std::vector<HammingScan> hammingScans() {
  std::vector<HammingScan> scans;
#ifdef __x86_64__
  if (hasVectorCounts()) scans.push_back(scanVectors);
  if (__builtin_cpu_supports("popcnt")) scans.push_back(scanWords);
#endif
  scans.push_back(scanPortably);
  return scans;
}

}  // namespace tolman::view_sequences
