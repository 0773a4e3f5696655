// SPDX-License-Identifier: BSD-3-Clause
#include "unicode_digits.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tolman::image_folders {
namespace {

/// The zeros of the scripts (Unicode's category Nd); the other digits follow them.
constexpr std::array<std::uint32_t, 17> kZeros = {0x0660, 0x06f0, 0x0966, 0x09e6, 0x0a66, 0x0ae6,
                                                  0x0b66, 0x0be6, 0x0c66, 0x0ce6, 0x0d66, 0x0e50,
                                                  0x0ed0, 0x0f20, 0x1040, 0x17e0, 0xff10};

/// Bytes of the character at the front, if it has two or three; otherwise 1.
std::size_t lengthOf(std::string_view text) {
  const auto lead = static_cast<std::uint8_t>(text.front());
  const std::size_t length = (lead & 0xe0U) == 0xc0 ? 2 : (lead & 0xf0U) == 0xe0 ? 3 : 1;
  const auto follows = [](char c) { return (static_cast<std::uint8_t>(c) & 0xc0U) == 0x80; };
  const std::string_view rest = text.substr(1, length - 1);
  return rest.size() == length - 1 && std::ranges::all_of(rest, follows) ? length : 1;
}

std::uint32_t codePoint(std::string_view character) {
  const std::uint32_t mask = character.size() == 2 ? 0x1fU : 0x0fU;
  std::uint32_t code = static_cast<std::uint8_t>(character.front()) & mask;
  for (const char c : character.substr(1)) {
    code = (code << 6U) | (static_cast<std::uint8_t>(c) & 0x3fU);
  }
  return code;
}

}  // namespace

std::string withLatinDigits(std::string_view text) {
  std::string latin;
  while (!text.empty()) {
    const std::string_view character = text.substr(0, lengthOf(text));
    text.remove_prefix(character.size());
    const std::uint32_t code = character.size() > 1 ? codePoint(character) : 0;
    const auto* zero =
        std::ranges::find_if(kZeros, [&](std::uint32_t z) { return code >= z && code < z + 10; });
    if (zero == kZeros.end()) {
      latin += character;
    } else {
      latin += static_cast<char>('0' + (code - *zero));
    }
  }
  return latin;
}

}  // namespace tolman::image_folders
