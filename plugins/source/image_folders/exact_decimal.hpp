// SPDX-License-Identifier: BSD-3-Clause
// Decimal numbers of any length, as texts and names of files have them, without rounding.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace tolman::image_folders {

/// 0.DIGITS * 10^point, negative if so marked. Digits have no zeros at either end; 0 has none.
struct ExactDecimal {
  bool negative = false;
  std::string digits;
  int point = 0;

  std::strong_ordering operator<=>(const ExactDecimal& other) const;
  bool operator==(const ExactDecimal& other) const = default;
};

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// The number that is the whole text: a sign, digits with at most one point, and an exponent of at
/// most 1000, such as "-12.5e-3". Empty for any other text.
std::optional<ExactDecimal> parseExactDecimal(std::string_view text);

}  // namespace tolman::image_folders
