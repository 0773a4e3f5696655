// SPDX-License-Identifier: BSD-3-Clause
// Numbers in text files. One rule for all readers: a decimal number, with a sign or without, all of
// the word, finite, and zero only if it is written as zero. What a double cannot hold, such as
// 1e400 or 1e-400, is refused, because taken as infinity or zero it would be another number.
#pragma once

#include <optional>
#include <string_view>

namespace tolman::text_encoding {

/// Empty for what is no number by the rule above.
std::optional<double> parseNumber(std::string_view word);

/// Why parseNumber() refuses a word, to follow it: "is no finite number", "is too small for a
/// double (write 0)" or "is too large for a double".
std::string_view numberProblem(std::string_view word);

}  // namespace tolman::text_encoding
