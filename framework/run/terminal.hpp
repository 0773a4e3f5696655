// SPDX-License-Identifier: BSD-3-Clause
// The line of a terminal on which a progress display may stand.
#pragma once

#include <string>
#include <string_view>

namespace tolman::run {

/// Columns of the terminal behind `descriptor`; 80 where that is not known.
int terminalWidth(int descriptor);

/// What must precede a line on `descriptor`, so that nothing of a progress line stays beside it: on
/// a terminal blanks over the present line, elsewhere nothing. Blanks work on every terminal.
std::string wipedLine(int descriptor);

/// The text without control characters, which a terminal would obey: `?` in their place, and in the
/// place of bytes that are no UTF-8. Line ends and tabs stay.
std::string printable(std::string_view text);

}  // namespace tolman::run
