// SPDX-License-Identifier: BSD-3-Clause
#include "exact_decimal.hpp"

#include <charconv>

namespace tolman::image_folders {
namespace {

constexpr int kLargestExponent = 1000;

/// Removes an optional sign; true for minus.
bool takeSign(std::string_view& text) {
  if (text.empty() || (text.front() != '-' && text.front() != '+')) return false;
  const bool minus = text.front() == '-';
  text.remove_prefix(1);
  return minus;
}

/// Removes the digits and the point before the exponent; empty without a digit.
std::optional<ExactDecimal> takeMantissa(std::string_view& text) {
  ExactDecimal number;
  bool after_point = false;
  bool any = false;
  for (; !text.empty() && (isDigit(text.front()) || (text.front() == '.' && !after_point));
       text.remove_prefix(1)) {
    if (text.front() == '.') {
      after_point = true;
      continue;
    }
    any = true;
    if (number.digits.empty() && text.front() == '0') {
      number.point -= after_point ? 1 : 0;  // leading zeros only shift the point
      continue;
    }
    number.digits += text.front();
    number.point += after_point ? 0 : 1;
  }
  return any ? std::optional(std::move(number)) : std::nullopt;
}

/// The exponent that is the whole text, "e-3"; 0 for none.
std::optional<int> parseExponent(std::string_view text) {
  if (text.empty()) return 0;
  if (text.front() != 'e' && text.front() != 'E') return std::nullopt;
  text.remove_prefix(1);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  int exponent = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (failure != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if (exponent < -kLargestExponent || exponent > kLargestExponent) return std::nullopt;
  return exponent;
}

std::strong_ordering compareMagnitudes(const ExactDecimal& a, const ExactDecimal& b) {
  if (a.digits.empty() || b.digits.empty()) return a.digits.size() <=> b.digits.size();
  if (a.point != b.point) return a.point <=> b.point;
  return a.digits.compare(b.digits) <=> 0;
}

}  // namespace

std::strong_ordering ExactDecimal::operator<=>(const ExactDecimal& other) const {
  if (negative != other.negative) {
    return negative ? std::strong_ordering::less : std::strong_ordering::greater;
  }
  return negative ? compareMagnitudes(other, *this) : compareMagnitudes(*this, other);
}

std::optional<ExactDecimal> parseExactDecimal(std::string_view text) {
  const bool negative = takeSign(text);
  std::optional<ExactDecimal> number = takeMantissa(text);
  if (!number) return std::nullopt;
  const std::optional<int> exponent = parseExponent(text);
  if (!exponent) return std::nullopt;
  number->digits.resize(number->digits.find_last_not_of('0') + 1);  // npos + 1 is 0
  if (number->digits.empty()) return ExactDecimal{};                // zero has no sign
  number->point += *exponent;
  number->negative = negative;
  return number;
}

}  // namespace tolman::image_folders
