// SPDX-License-Identifier: BSD-3-Clause
// Text for a terminal: its width, lines beside a progress display, and printable text.
#pragma once

#include <string>
#include <string_view>

namespace tolman::run {

/// Columns of the terminal behind `descriptor`; 80 where that is not known.
int terminalWidth(int descriptor);

/// Text to write before a line on `descriptor`, so that it replaces a progress line: on a terminal
/// blanks over the present line (they work on every terminal), elsewhere nothing.
std::string wipedLine(int descriptor);

/// Replaces control characters, which a terminal would execute, and bytes that are not UTF-8 by
/// `?`. Line ends and tabs are kept.
std::string printable(std::string_view text);

}  // namespace tolman::run
