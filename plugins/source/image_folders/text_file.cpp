// SPDX-License-Identifier: BSD-3-Clause
#include "text_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "base/open_files.hpp"
#include "base/text_encoding.hpp"
#include "exact_decimal.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kSeparators = " \t\r,;";

/// Whether the last line, which has no end, was cut within its last field: the field has fewer
/// decimals (characters, where it has no point) than that of every line before.
bool isCut(const std::vector<TextLine>& lines) {
  if (lines.size() < 3) return false;
  const auto length = [](const TextLine& line) {
    const std::string_view field = splitFields(line.text).back();
    const std::size_t point = field.find('.');
    return field.size() - (point == std::string_view::npos ? 0 : point);
  };
  const std::size_t last = length(lines.back());
  return std::all_of(lines.begin(), lines.end() - 1,
                     [&](const TextLine& line) { return length(line) > last; });
}

}  // namespace

std::vector<TextLine> readLines(const fs::path& file, Inspection& inspection) {
  constexpr std::uintmax_t kMaxBytes = 256U << 20U;
  std::error_code failure;
  const fs::file_status status = fs::status(file, failure);
  if (!fs::is_regular_file(status)) {
    const bool is_other = fs::exists(status) || status.type() == fs::file_type::none;
    const std::string why = fs::exists(status) ? "is no regular file" : failure.message();
    inspection.error(file, is_other ? why + "; put a text file in its place"
                                    : "is missing; restore it, or correct the path");
    return {};
  }
  if (fs::file_size(file, failure) > kMaxBytes || failure) {
    inspection.error(file, "is larger than 256 MiB; this is not the text file that is wanted");
    return {};
  }
  if (const std::string problem = text_encoding::encodingProblemOf(file); !problem.empty()) {
    inspection.error(file, problem);
    return {};
  }
  std::ifstream stream(file, std::ios::binary);
  std::vector<TextLine> lines;
  int number = 0;
  bool has_end = true;  // of its last line
  for (std::string text; std::getline(stream, text);) {
    has_end = !stream.eof();
    ++number;
    if (number == 1) text = text_encoding::withoutMark(text);
    const std::size_t begin = text.find_first_not_of(kSeparators);
    if (begin == std::string::npos || text[begin] == '#') continue;
    if (text.back() == '\r') text.pop_back();
    lines.push_back({number, std::move(text)});
  }
  if (!stream.eof())
    inspection.error(file, file_opening::notOpened("cannot be read; check its permissions"));
  if (stream.eof() && lines.empty()) inspection.error(file, "is empty; restore it");
  if (!has_end && isCut(lines)) {
    inspection.error(file, "ends within line " + std::to_string(number) +
                               ", whose last number is cut; put back the whole file");
    lines.clear();
  }
  return lines;
}

std::vector<std::string_view> splitFields(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t begin = line.find_first_not_of(kSeparators);
    if (begin == std::string_view::npos) return fields;
    line.remove_prefix(begin);
    fields.push_back(line.substr(0, line.find_first_of(kSeparators)));
    line.remove_prefix(fields.back().size());
  }
}

std::string inQuotes(std::string_view field) {
  constexpr std::size_t kMax = 24;
  std::string text = "'";
  for (const char c : field.substr(0, kMax)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (field.size() > kMax ? "...'" : "'");
}

std::optional<std::int64_t> parseSeconds(std::string_view field, int digits_of_unit) {
  const std::optional<ExactDecimal> seconds = parseExactDecimal(field);
  // Small times are rounded to whole nanoseconds, but one that no double holds is no time.
  if (!seconds || !parseNumber(field)) return std::nullopt;
  const int length =
      seconds->point + digits_of_unit;  // digits before the point, counted in nanoseconds
  if (seconds->digits.empty() || length < 0) return 0;
  if (length > 19) return std::nullopt;
  std::string digits = seconds->digits;
  digits.resize(std::max(digits.size(), static_cast<std::size_t>(length) + 1), '0');
  std::uint64_t ns = 0;  // 19 digits fit
  for (const char digit : digits.substr(0, static_cast<std::size_t>(length))) {
    ns = ns * 10 + static_cast<std::uint64_t>(digit - '0');
  }
  if (digits[static_cast<std::size_t>(length)] >= '5') ++ns;
  if (ns > std::uint64_t{1} << 62U) return std::nullopt;
  return seconds->negative ? -static_cast<std::int64_t>(ns) : static_cast<std::int64_t>(ns);
}

std::string fixed(double value, int digits) {
  char text[64];
  const int size = std::snprintf(text, sizeof text, "%.*f", digits, value);
  return {text, static_cast<std::size_t>(std::clamp(size, 0, 63))};
}

}  // namespace tolman::image_folders
