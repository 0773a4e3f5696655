// SPDX-License-Identifier: BSD-3-Clause
#include "image_name.hpp"

#include <algorithm>
#include <array>

#include "exact_decimal.hpp"
#include "unicode_digits.hpp"

namespace tolman::image_folders {
namespace {

/// Removes the leading digits from `text` and returns them.
std::string_view takeDigits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), isDigit);
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  return digits;
}

std::string_view withoutZeros(std::string_view digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size()));
}

/// Negative, 0 or positive if a is before, equal to or after b; leading zeros are ignored.
int naturalOrder(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (isDigit(a.front()) && isDigit(b.front())) {
      const std::string_view number_a = withoutZeros(takeDigits(a));
      const std::string_view number_b = withoutZeros(takeDigits(b));
      if (number_a.size() != number_b.size()) return number_a.size() < number_b.size() ? -1 : 1;
      if (const int order = number_a.compare(number_b); order != 0) return order;
    } else {
      const auto byte_a = static_cast<unsigned char>(a.front());
      const auto byte_b = static_cast<unsigned char>(b.front());
      if (byte_a != byte_b) return byte_a < byte_b ? -1 : 1;
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return static_cast<int>(!a.empty()) - static_cast<int>(!b.empty());
}

void replaceAll(std::string& text, std::string_view what, char by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at)) {
    text.replace(at, what.size(), 1, by);
  }
}

/// Latin digits, '-' as minus sign, lower case, no blanks at the ends.
std::string foldedName(std::string_view stem) {
  // U+2212 (minus sign), U+2010, U+2011, U+2013 (hyphens, dash), U+FE63, U+FF0D in UTF-8
  constexpr std::array<std::string_view, 6> kMinus = {"\xe2\x88\x92", "\xe2\x80\x90",
                                                      "\xe2\x80\x91", "\xe2\x80\x93",
                                                      "\xef\xb9\xa3", "\xef\xbc\x8d"};
  std::string name = withLatinDigits(stem);
  for (const std::string_view minus : kMinus) replaceAll(name, minus, '-');
  std::ranges::transform(name, name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  name.erase(0, std::min(name.find_first_not_of(' '), name.size()));
  name.resize(name.find_last_not_of(' ') + 1);  // npos + 1 is 0
  return name;
}

/// How many runs of digits, joined by this character, are at the front: 3 of "12.30.05". Removes
/// them.
int takeJoinedRuns(std::string_view& text, char joint) {
  int runs = 0;
  while (!text.empty() && isDigit(text.front())) {
    ++runs;
    takeDigits(text);
    if (text.size() > 1 && text[0] == joint && isDigit(text[1])) text.remove_prefix(1);
  }
  return runs;
}

/// The same for points, or for commas where there are none: of "12,3.5" only 12 is the first.
int joinedRuns(std::string_view text) {
  std::string_view rest = text;
  const int by_points = takeJoinedRuns(rest, '.');
  if (by_points > 1) return by_points;
  rest = text;
  const int by_commas = takeJoinedRuns(rest, ',');
  return by_commas == 2 && rest.starts_with('.') ? 1 : by_commas;
}

/// The length of an exponent with sign at the front, as in "1e-05"; 0 for none.
std::size_t exponentLength(std::string_view text) {
  if (text.size() < 3 || text[0] != 'e' || (text[1] != '-' && text[1] != '+')) return 0;
  std::string_view rest = text.substr(2);
  const std::size_t digits = takeDigits(rest).size();
  return digits > 0 ? digits + 2 : 0;
}

/// A whole number, or one with fraction and exponent, without sign.
ExactDecimal takeNumber(std::string_view& text, bool with_fraction, bool with_exponent) {
  std::string number(takeDigits(text));
  if (with_fraction) {
    text.remove_prefix(1);
    number += '.';
    number += takeDigits(text);
  }
  const std::size_t exponent = with_exponent ? exponentLength(text) : 0;
  if (const auto value = parseExactDecimal(number + std::string(text.substr(0, exponent)))) {
    text.remove_prefix(exponent);
    return *value;
  }
  return parseExactDecimal(number).value_or(ExactDecimal{});  // the exponent is beyond 1000
}

/// Whether the sign at `at` is that of a number: it follows nothing but a separator.
bool isSign(std::string_view name, std::size_t at) {
  if (name[at] != '-' && name[at] != '+') return false;
  if (at + 1 >= name.size() || !isDigit(name[at + 1])) return false;
  if (at == 0) return true;
  constexpr std::string_view kSeparators = "_ =:;,.([{#@";
  return kSeparators.find(name[at - 1]) != std::string_view::npos;
}

/// Bytes that compare as the numbers do: sign, power of ten, digits and their end. Those of
/// negative numbers are complements.
std::string keyOf(const ExactDecimal& number) {
  constexpr int kBytes = 2;
  constexpr int kMiddle = 1 << 15;  // powers are of names of at most 255 bytes, and exponents 1000
  if (number.digits.empty()) return "1";
  std::string key;
  for (int byte = kBytes - 1; byte >= 0; --byte) {
    key += static_cast<char>(static_cast<unsigned>(number.point + kMiddle) >> (8 * byte) & 0xffU);
  }
  key += number.digits + '\0';
  if (number.negative) std::ranges::transform(key, key.begin(), [](char c) { return ~c; });
  return (number.negative ? "0" : "2") + key;
}

/// Numbers have the place of digits among the characters.
void addNumber(const ExactDecimal& number, ImageName& parsed) {
  parsed.text += '0';
  parsed.key += '0' + keyOf(number);
}

void addCharacter(char c, ImageName& parsed) {
  parsed.text += c;
  parsed.key += c;
}

void addAll(std::string_view name, ImageName& parsed) {
  std::size_t at = 0;
  while (at < name.size()) {
    const bool has_sign = isSign(name, at);
    std::string_view rest = name.substr(at + (has_sign ? 1 : 0));
    if (!isDigit(rest.front())) {
      addCharacter(name[at++], parsed);
      continue;
    }
    const int runs = joinedRuns(rest);
    const bool minus = has_sign && name[at] == '-';
    for (int run = 0; run < (runs > 2 ? runs : 1); ++run) {
      if (run > 0) {
        addCharacter(rest.front(), parsed);
        rest.remove_prefix(1);
      }
      ExactDecimal number = takeNumber(rest, runs == 2, runs <= 2);
      number.negative = minus && run == 0 && !number.digits.empty();
      addNumber(number, parsed);
    }
    parsed.has_version = parsed.has_version || runs > 2;
    at = name.size() - rest.size();
  }
}

}  // namespace

ImageName parseImageName(std::string_view stem, bool numeric) {
  ImageName parsed;
  parsed.stem = stem;
  const std::string name = foldedName(stem);
  const std::optional<ExactDecimal> whole = numeric ? parseExactDecimal(name) : std::nullopt;
  if (whole) {
    addNumber(*whole, parsed);
  } else {
    addAll(name, parsed);
  }
  return parsed;
}

bool naturalLess(std::string_view a, std::string_view b) {
  const int order = naturalOrder(a, b);
  return order != 0 ? order < 0 : a < b;
}

std::string withPlainSeparators(std::string_view stem) {
  std::string plain = withLatinDigits(stem);
  replaceAll(plain, "\xe2\x80\x99", '\'');  // U+2019, as Switzerland prints it
  // U+00A0, U+2009, U+202F: blanks that do not break a line, as France prints them
  for (const char* blank : {"\xc2\xa0", "\xe2\x80\x89", "\xe2\x80\xaf"}) {
    replaceAll(plain, blank, ' ');
  }
  return plain;
}

std::string withSignsApart(std::string_view stem) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  std::string folded = foldedName(stem);
  const std::size_t digit = folded.find_first_of("0123456789");
  if (digit == std::string::npos) return folded;
  const bool has_sign = digit > 0 && folded[digit - 1] == '-';
  const std::size_t begin = digit - (has_sign ? 1 : 0);
  if (begin > 0 && isLetter(folded[begin - 1])) folded.insert(begin, "_");
  return folded;
}

std::string withoutThousands(std::string_view text, char separator) {
  constexpr std::size_t kGroup = 3;
  std::string without;
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string_view rest = text.substr(at + 1);
    const bool separates = text[at] == separator && at > 0 && isDigit(text[at - 1]) &&
                           takeDigits(rest).size() == kGroup;
    if (!separates) without += text[at];
  }
  return without;
}

}  // namespace tolman::image_folders
