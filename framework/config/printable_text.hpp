// SPDX-License-Identifier: BSD-3-Clause
// Text that terminals, XML and JSON can show: UTF-8 without control characters.
#pragma once

#include <string>
#include <string_view>

namespace tolman::config {

/// Whether all characters are printable. True for an empty text.
bool isPrintable(std::string_view text);

/// With `instead` (U+FFFD) in place of each control character and of each byte that is no UTF-8;
/// line feeds and tabulators stay.
std::string printable(std::string_view text, std::string_view instead = "\xef\xbf\xbd");

}  // namespace tolman::config
