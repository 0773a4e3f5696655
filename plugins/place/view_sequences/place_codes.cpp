// SPDX-License-Identifier: BSD-3-Clause
#include "place_codes.hpp"

#include <algorithm>

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

namespace {

// Cells between the tried shifts: codes hardly change over one cell. Chosen, not tuned.
constexpr int kCodeShift = 2;

/// splitmix64 (Steele et al., OOPSLA 2014): the same numbers everywhere.
std::uint64_t nextRandom(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

}  // namespace

CodeMaker::CodeMaker() {
  std::uint64_t state = 20;  // seed; any other gives other codes
  for (auto& terms : terms_) {
    for (std::uint16_t& term : terms) {
      term = static_cast<std::uint16_t>(nextRandom(state) % kValues);
    }
  }
}

PlaceCode CodeMaker::codeOf(const EdgeValues& deviation) const {
  PlaceCode code{};
  for (std::size_t bit = 0; bit < kCodeBits; ++bit) {
    float sum = 0;
    for (std::size_t t = 0; t < kTerms / 2; ++t) {
      sum += deviation[terms_[bit][t]] - deviation[terms_[bit][t + kTerms / 2]];
    }
    if (sum > 0) code[bit / 64] |= std::uint64_t{1} << (bit % 64);
  }
  return code;
}

PlaceCode CodeMaker::codeOfShifted(const EdgeValues& deviation, int shift) const {
  EdgeValues shifted{};
  const int kept = (kColumns - std::abs(shift)) * kColumnValues;
  std::copy_n(deviation.begin() + std::max(0, -shift) * kColumnValues, kept,
              shifted.begin() + std::max(0, shift) * kColumnValues);
  return codeOf(shifted);
}

void PlaceCodes::update(const ViewBank& bank) {
  std::array<std::int16_t, kValues> levels;
  EdgeValues deviation;
  while (chunks_ < bank.chunks().size() && bank.isSettled(chunks_)) {
    const Chunk& chunk = bank.chunks()[chunks_++];
    for (std::int64_t i = chunk.first; i < chunk.first + chunk.count; ++i) {
      unpack(bank.view(i), levels);
      for (std::size_t k = 0; k < kValues; ++k) {
        deviation[k] = levels[k] - static_cast<float>(chunk.mean[k]) / kMeanScale;
      }
      codes_.push_back(maker_.codeOf(deviation));
    }
  }
}

void PlaceCodes::distances(const ViewQuery& query, std::vector<std::uint16_t>& bits) const {
  CodeQueries queries;
  for (int i = 0; i < kTriedShifts; ++i) {
    queries[static_cast<std::size_t>(i)] =
        maker_.codeOfShifted(query.deviation(), (i - kTriedShifts / 2) * kCodeShift);
  }
  bits.resize(codes_.size());
  hammingScans().front()(codes_.data(), size(), queries, bits.data());
}

}  // namespace tolman::view_sequences
