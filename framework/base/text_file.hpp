// SPDX-License-Identifier: BSD-3-Clause
// Text files that other programs and people write: as a whole, as numbered lines, as fields.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/status.hpp"

namespace tolman::text_encoding {

/// The whole file as UTF-8 without byte order mark. A failure reads "FILE: what; remedy".
Result<std::string> readText(const std::filesystem::path& file,
                             std::uintmax_t most_bytes = std::uintmax_t{256} << 20U);

struct TextLine {
  int number = 0;  ///< from 1
  std::string text;
};

/// The lines that are neither blank nor comments ('#'), without line ends.
std::vector<TextLine> contentLines(std::string_view text);

/// The fields between blanks, commas and semicolons.
std::vector<std::string_view> splitFields(std::string_view line);

/// A field in quotes for a message, shortened and made printable.
std::string inQuotes(std::string_view field);

/// Converts a decimal number, with or without exponent, to nanoseconds. `digits` is the decimal
/// exponent of its unit in ns: 9 for seconds, 0 for nanoseconds. Exact, then rounded half away from
/// zero; through a double, 1.6e9 s would be off by 100 ns. Empty beyond 2^62 ns (146 years).
std::optional<std::int64_t> parseSeconds(std::string_view field, int digits = 9);

/// A number for a message, with `digits` after the point.
std::string fixed(double value, int digits);

/// A number for a message, with `digits` significant ones.
std::string rounded(double value, int digits = 4);

/// What keeps a text from being read as UTF-8, with the remedy: the mark of UTF-16, which some
/// editors save, or a zero byte and its line; a reader would blame a line or a number. Empty for a
/// sound text. Other bytes that are no UTF-8 are not looked for.
std::string encodingProblem(std::string_view text);

/// Removes the byte order mark that some editors write before UTF-8.
std::string_view withoutMark(std::string_view text);

/// A decimal number, with a sign or without, all of the word, finite, and zero only if it is
/// written as zero: what a double cannot hold, such as 1e400 or 1e-400, would be another number.
/// Else empty.
std::optional<double> parseNumber(std::string_view word);

/// Why parseNumber() refuses a word, to follow it: "is no finite number", "is too small for a
/// double (write 0)" or "is too large for a double".
std::string_view numberProblem(std::string_view word);

}  // namespace tolman::text_encoding
