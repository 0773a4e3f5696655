// SPDX-License-Identifier: BSD-3-Clause
// Text that terminals, XML and JSON can show: UTF-8 without control characters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tolman::config {

/// Bytes of the printable character that `text` begins with; 0 where it begins with none.
std::size_t printableLength(std::string_view text);

/// Whether all characters are printable. True for an empty text.
bool isPrintable(std::string_view text);

/// With U+FFFD in place of each byte that is not part of a printable character; line feeds and
/// tabulators stay.
std::string printable(std::string_view text);

}  // namespace tolman::config
