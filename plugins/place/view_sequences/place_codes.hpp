// SPDX-License-Identifier: BSD-3-Clause
// Counts the differing bits between a few codes and all stored ones: the part of the search whose
// time is proportional to the number of stored views.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "view_bank.hpp"

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

// A code of 256 bits for each view: the signs of 256 random sums of its deviation from the mean
// (Charikar, STOC 2002). The Hamming distance between codes increases with the angle between
// deviations. A million codes are compared in a few milliseconds.

/// The random sums are the same in every build and run.
class CodeMaker {
 public:
  CodeMaker();
  PlaceCode codeOf(const EdgeValues& deviation) const;
  /// The code of the view with its scene shifted to the right by `shift` cells; cells that are then
  /// unknown get the mean.
  PlaceCode codeOfShifted(const EdgeValues& deviation, int shift) const;

 private:
  static constexpr int kTerms = 48;  // chosen, not tuned
  /// Indices of values for each bit: the first half is added, the other subtracted.
  std::array<std::array<std::uint16_t, kTerms>, kCodeBits> terms_;
};

/// Codes of the stored views whose chunk has its final mean. These are the first ones of the bank.
class PlaceCodes {
 public:
  /// Makes the codes of all chunks that have become final.
  void update(const ViewBank& bank);
  std::int64_t size() const { return static_cast<std::int64_t>(codes_.size()); }
  /// Smallest number of differing bits to any of the tried shifts of the query, for each code.
  void distances(const ViewQuery& query, std::vector<std::uint16_t>& bits) const;

 private:
  CodeMaker maker_;
  std::vector<PlaceCode> codes_;
  std::size_t chunks_ = 0;  ///< number of chunks that have codes
};

}  // namespace tolman::view_sequences
