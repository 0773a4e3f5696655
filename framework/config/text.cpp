// SPDX-License-Identifier: BSD-3-Clause
#include "config/text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace tolman::config {
namespace {

char folded(char c) {
  if (c == '-') return '_';
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool sameLetter(char a, char b) { return folded(a) == folded(b); }

/// Unicode's ranges without printable characters: control characters, surrogates, and the two that
/// XML forbids.
constexpr bool isControl(std::uint32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || (c >= 0xd800 && c < 0xe000) || c == 0xfffe ||
         c == 0xffff;
}

/// Length of a UTF-8 character by its first byte; 0 if no character begins with this byte.
constexpr std::size_t lengthOf(std::uint8_t first) {
  if (first < 0x80) return 1;
  if (first < 0xc2) return 0;
  if (first < 0xe0) return 2;
  if (first < 0xf0) return 3;
  return first < 0xf5 ? 4 : 0;
}

struct Character {
  std::size_t length;  ///< bytes, at least 1
  bool is_printable;
};

/// The first character of a text that is not empty.
Character firstOf(std::string_view text) {
  constexpr Character kNone = {1, false};
  const auto first = static_cast<std::uint8_t>(text[0]);
  const std::size_t length = lengthOf(first);
  if (length == 0 || length > text.size()) return kNone;
  std::uint32_t c = length == 1 ? first : first & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<std::uint8_t>(text[i]);
    if ((next & 0xc0U) != 0x80U) return kNone;
    c = c << 6U | (next & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> kMin = {0, 0, 0x80, 0x800, 0x10000};
  if (c < kMin.at(length) || c > 0x10ffff) return kNone;
  return {length, !isControl(c)};
}

}  // namespace

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);  // row i - 2 of the table, then i - 1, then i
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (sameLetter(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped =
          i > 1 && j > 1 && sameLetter(a[i - 1], b[j - 2]) && sameLetter(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

std::optional<std::string> nearestName(std::string_view name,
                                       std::span<const std::string> candidates) {
  std::optional<std::string> nearest;
  std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(name, candidate);
    const bool shares_letters = distance < std::min(name.size(), candidate.size());
    if (distance >= least || !shares_letters) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

std::string didYouMean(std::string_view name, std::span<const std::string> candidates) {
  const auto nearest = nearestName(name, candidates);
  return nearest ? "; did you mean '" + *nearest + "'?" : "";
}

std::string listed(std::span<const std::string> names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

bool isPrintable(std::string_view text) {
  return text.find_first_of("\n\t") == std::string_view::npos && printable(text, "") == text;
}

std::string printable(std::string_view text, std::string_view instead) {
  std::string safe;
  safe.reserve(text.size());
  while (!text.empty()) {
    const bool is_space = text[0] == '\n' || text[0] == '\t';
    const Character character = firstOf(text);
    const bool stays = is_space || character.is_printable;
    safe.append(stays ? text.substr(0, character.length) : instead);
    text.remove_prefix(character.length);
  }
  return safe;
}

}  // namespace tolman::config
