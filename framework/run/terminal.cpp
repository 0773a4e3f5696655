// SPDX-License-Identifier: BSD-3-Clause
#include "run/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace tolman::run {
namespace {

/// Bytes of the UTF-8 character that `text` begins with; 0 where there is none.
std::size_t characterLength(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xc2 && lead < 0xe0 ? 2
                             : lead >= 0xe0 && lead < 0xf0 ? 3
                             : lead >= 0xf0 && lead < 0xf5 ? 4
                                                           : 0;
  if (length > text.size()) return 0;
  for (const char c : text.substr(1, std::max<std::size_t>(length, 1) - 1)) {
    if ((static_cast<unsigned char>(c) & 0xc0U) != 0x80) return 0;
  }
  return length;
}

/// Also those of two bytes, U+0080 to U+009F.
bool isControl(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  if (character.size() == 2)
    return first == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0;
  return character.size() == 1 && (first < ' ' || first == 0x7f) && first != '\n' && first != '\t';
}

}  // namespace

int terminalWidth(int descriptor) {
  winsize size{};
  const bool known = ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

std::string wipedLine(int descriptor) {
  if (::isatty(descriptor) != 1) return {};
  return "\r" + std::string(static_cast<std::size_t>(terminalWidth(descriptor) - 1), ' ') + "\r";
}

std::string printable(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = characterLength(text.substr(i));
    const std::string_view character = text.substr(i, length);
    if (length > 0 && !isControl(character)) {
      shown += character;
    } else {
      shown += '?';
    }
    i += std::max<std::size_t>(length, 1);
  }
  return shown;
}

}  // namespace tolman::run
