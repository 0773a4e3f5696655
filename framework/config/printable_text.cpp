// SPDX-License-Identifier: BSD-3-Clause
#include "config/printable_text.hpp"

#include <algorithm>
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

/// Number of bytes that a first byte announces; 0 for one that cannot be first.
constexpr std::size_t lengthOf(std::uint8_t first) {
  if (first < 0x80) return 1;
  if (first < 0xc2) return 0;
  if (first < 0xe0) return 2;
  if (first < 0xf0) return 3;
  return first < 0xf5 ? 4 : 0;
}

}  // namespace

std::size_t printableLength(std::string_view text) {
  if (text.empty()) return 0;
  const auto first = static_cast<std::uint8_t>(text[0]);
  const std::size_t length = lengthOf(first);
  if (length == 0 || length > text.size()) return 0;
  std::uint32_t c = length == 1 ? first : first & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<std::uint8_t>(text[i]);
    if ((next & 0xc0U) != 0x80U) return 0;
    c = c << 6U | (next & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  return c >= kLeast.at(length) && c <= 0x10ffff && !isControl(c) ? length : 0;
}

bool isPrintable(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = printableLength(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  while (!text.empty()) {
    const bool is_space = text[0] == '\n' || text[0] == '\t';
    const std::size_t length = is_space ? 1 : printableLength(text);
    length > 0 ? safe.append(text.substr(0, length)) : safe.append("\xef\xbf\xbd");
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return safe;
}

}  // namespace tolman::config
