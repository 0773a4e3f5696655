// SPDX-License-Identifier: BSD-3-Clause
#include "base/text_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace tolman::text_encoding {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kSeparators = " \t\r,;";

std::string printed(const char* format, int digits, double value) {
  std::array<char, 64> text{};
  const int size = std::snprintf(text.data(), text.size(), format, digits, value + 0.0);  // not -0
  return {text.data(), static_cast<std::size_t>(std::clamp(size, 0, 63))};
}

/// from_chars() does not accept a plus sign.
std::string_view withoutPlus(std::string_view word) {
  const bool has_plus = word.starts_with('+') && !word.starts_with("+-");
  return word.substr(has_plus ? 1 : 0);
}

std::errc parse(std::string_view word, double& value) {
  const std::string_view digits = withoutPlus(word);
  const char* const all = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), all, value);
  return error == std::errc() && end != all ? std::errc::invalid_argument : error;
}

/// A number as 0.DIGITS * 10^point.
struct Decimal {
  bool negative = false;
  std::string digits;
  int point = 0;
};

/// `field` is a number by parseNumber().
Decimal decimalOf(std::string_view field) {
  Decimal number;
  number.negative = field.starts_with('-');
  const std::size_t exponent_at = std::min(field.find_first_of("eE"), field.size());
  const std::string_view mantissa = field.substr(0, exponent_at);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  for (std::size_t i = 0; i < mantissa.size(); ++i) {
    const char c = mantissa[i];
    if (c < '0' || c > '9' || (c == '0' && number.digits.empty())) {
      number.point -= c == '0' && i > point ? 1 : 0;  // a leading zero behind the point
      continue;
    }
    number.digits += c;
    number.point += i < point ? 1 : 0;
  }
  std::string_view exponent = field.substr(std::min(exponent_at + 1, field.size()));
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  int power = 0;
  std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
  number.point += power;
  return number;
}

}  // namespace

Result<std::string> readText(const fs::path& file, std::uintmax_t most_bytes) {
  const auto fail = [&](const std::string& what) {
    return Status::invalidInput(file.string() + ": " + what);
  };
  std::error_code failure;
  const fs::file_status status = fs::status(file, failure);
  if (status.type() == fs::file_type::not_found) {
    return fail("is missing; restore it, or correct the path");
  }
  if (!fs::is_regular_file(status)) return fail("is no text file; correct the path");
  if (fs::file_size(file, failure) > most_bytes || failure) {
    return fail("is larger than " + std::to_string(most_bytes >> 20U) +
                " MiB; this is not the text file that is wanted");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream.is_open() || stream.bad()) return fail("cannot be read; check its permissions");
  if (const std::string problem = encodingProblem(text); !problem.empty()) return fail(problem);
  return std::string(withoutMark(text));
}

std::vector<TextLine> contentLines(std::string_view text) {
  std::vector<TextLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::size_t begin = line.find_first_not_of(kSeparators);
    if (begin == std::string_view::npos || line[begin] == '#') continue;
    lines.push_back({number, std::string(line)});
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
  constexpr std::size_t kMost = 24;  // characters of a message
  std::string text = "'";
  for (const char c : field.substr(0, kMost)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (field.size() > kMost ? "...'" : "'");
}

std::optional<std::int64_t> parseSeconds(std::string_view field, int digits_of_unit) {
  if (!parseNumber(field)) return std::nullopt;
  Decimal seconds = decimalOf(field);
  const int whole = seconds.point + digits_of_unit;  // digits before the point, in nanoseconds
  if (seconds.digits.empty() || whole < 0) return 0;
  if (whole > 19) return std::nullopt;
  const auto length = static_cast<std::size_t>(whole);
  seconds.digits.resize(std::max(seconds.digits.size(), length + 1), '0');
  std::uint64_t ns = 0;  // 19 digits fit
  for (const char digit : seconds.digits.substr(0, length)) {
    ns = ns * 10 + static_cast<std::uint64_t>(digit - '0');
  }
  if (seconds.digits[length] >= '5') ++ns;
  if (ns > std::uint64_t{1} << 62U) return std::nullopt;
  return seconds.negative ? -static_cast<std::int64_t>(ns) : static_cast<std::int64_t>(ns);
}

std::string fixed(double value, int digits) { return printed("%.*f", digits, value); }

std::string rounded(double value, int digits) { return printed("%.*g", digits, value); }

std::string encodingProblem(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return "is UTF-16; save it as UTF-8";
  }
  const std::size_t zero = text.find('\0');
  if (zero == std::string_view::npos) return "";
  const auto line = 1 + std::ranges::count(text.substr(0, zero), '\n');
  return "has a zero byte in line " + std::to_string(line) +
         ": it is UTF-16, damaged or no text; save it as UTF-8";
}

std::string_view withoutMark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.substr(text.starts_with(kMark) ? kMark.size() : 0);
}

std::optional<double> parseNumber(std::string_view word) {
  double value = 0;
  const bool sound = parse(word, value) == std::errc() && std::isfinite(value);
  return sound ? std::optional(value) : std::nullopt;
}

std::string_view numberProblem(std::string_view word) {
  double value = 0;
  if (parse(word, value) != std::errc::result_out_of_range) return "is no finite number";
  const double nearest = std::strtod(std::string(withoutPlus(word)).c_str(), nullptr);
  return std::abs(nearest) < 1 ? "is too small for a double (write 0)"
                               : "is too large for a double";
}

}  // namespace tolman::text_encoding
