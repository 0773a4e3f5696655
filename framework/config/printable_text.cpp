// SPDX-License-Identifier: BSD-3-Clause
#include "config/printable_text.hpp"

#include <array>
#include <cstdint>

namespace tolman::config {
namespace {

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

bool isPrintable(std::string_view text) {
  while (!text.empty()) {
    const Character character = firstOf(text);
    if (!character.is_printable) return false;
    text.remove_prefix(character.length);
  }
  return true;
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
