// SPDX-License-Identifier: BSD-3-Clause
// Small text files as numbered lines of fields, and the numbers in them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/number_text.hpp"
#include "inspection.hpp"

namespace tolman::image_folders {

struct TextLine {
  int number = 0;  ///< from 1
  std::string text;
};

/// All lines but blank ones and '#' comments, without line ends and byte order mark. A file that
/// cannot be read, has no such lines or was cut within its last field gives an error in
/// `inspection` and no lines.
std::vector<TextLine> readLines(const std::filesystem::path& file, Inspection& inspection);

/// The fields between blanks, commas and semicolons.
std::vector<std::string_view> splitFields(std::string_view line);

/// A field in quotes for a message, shortened and made printable.
std::string inQuotes(std::string_view field);

using text_encoding::numberProblem;
using text_encoding::parseNumber;

/// Converts a decimal number, with or without exponent, to nanoseconds. Its unit is 10^-9 *
/// 10^`digits` s: 9 for seconds, 0 for nanoseconds. The conversion is exact, then rounded half away
/// from zero; with a double, 1.6e9 s would have errors of 100 ns. Empty beyond 2^62 ns (146 years).
std::optional<std::int64_t> parseSeconds(std::string_view field, int digits = 9);

/// A number for a message, with `digits` after the point.
std::string fixed(double value, int digits);

}  // namespace tolman::image_folders
