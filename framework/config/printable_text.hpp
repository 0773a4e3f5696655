// SPDX-License-Identifier: BSD-3-Clause
// Text that terminals, XML and JSON can show: UTF-8 without control characters.
#pragma once

#include <string>
#include <string_view>

namespace tolman::config {

/// Whether all characters are printable. True for an empty text.
bool isPrintable(std::string_view text);

/// Replaces each control character and each byte that is not UTF-8 by `instead` (U+FFFD); keeps
/// line feeds and tabulators.
std::string printable(std::string_view text, std::string_view instead = "\xef\xbf\xbd");

}  // namespace tolman::config
