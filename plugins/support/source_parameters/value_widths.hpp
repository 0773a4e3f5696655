// SPDX-License-Identifier: BSD-3-Clause
// How many bits the values of an image of 16 bits need: for each number of bits the count of the
// values and the largest, so that a few large ones can be left out.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace tolman::source_parameters {

class ValueWidths {
 public:
  void add(std::uint16_t value) {
    const auto width = static_cast<std::size_t>(std::bit_width(value));
    ++counts_[width];
    largest_[width] = std::max(largest_[width], static_cast<int>(value));
  }

  /// -1 without values.
  int largest() const { return largestBut(0); }

  /// The largest value of those that need no more bits than all but one in ten thousand values do;
  /// -1 without values. Hot pixels and reflections are fewer; the share was chosen, not tuned.
  int usual() const {
    constexpr std::size_t kShare = 10'000;
    std::size_t all = 0;
    for (const std::size_t count : counts_) all += count;
    return largestBut(all / kShare);
  }

 private:
  /// The largest value if at most `few` values that need more bits are left out.
  int largestBut(std::size_t few) const {
    std::size_t beyond = 0;
    for (std::size_t width = kWidths; width-- > 0;) {
      beyond += counts_[width];
      if (beyond > few) return largest_[width];
    }
    return -1;
  }

  static constexpr std::size_t kWidths = 17;  // 0 to 16 bits
  std::array<std::size_t, kWidths> counts_ = {};
  std::array<int, kWidths> largest_ = {};
};

}  // namespace tolman::source_parameters
