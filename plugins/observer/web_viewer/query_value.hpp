// SPDX-License-Identifier: BSD-3-Clause
// Values in the query of a request, in which a client may write any byte as %XX (RFC 3986, section
// 2.1), and a blank as + (forms of HTML).
#pragma once

#include <charconv>
#include <string>
#include <string_view>

namespace tolman::web_viewer {

/// The value in plain text. A % without two hexadecimal digits stays.
inline std::string decodedValue(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    unsigned byte = 0;
    const char* digits = text.data() + at + 1;
    const bool coded = text[at] == '%' && at + 2 < text.size() &&
                       std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    plain += coded ? static_cast<char>(byte) : text[at] == '+' ? ' ' : text[at];
    if (coded) at += 2;
  }
  return plain;
}

}  // namespace tolman::web_viewer
