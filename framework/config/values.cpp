// SPDX-License-Identifier: BSD-3-Clause
#include "config/values.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <system_error>

#include "config/text.hpp"

namespace tolman::config {
namespace {

bool isPlainWord(const std::string& text) {
  const auto inner = [](char c) {
    return isLetter(c) || isDigit(c) || c == '_' || c == '-' || c == '.' || c == '/';
  };
  if (text.empty() || !(isLetter(text.front()) || text.front() == '/')) return false;
  return std::ranges::all_of(text, inner) && text != "null" && text != "Null" && text != "NULL";
}

std::string quoted(const std::string& text) {
  static constexpr std::string_view kHex = "0123456789abcdef";
  std::string out = "\"";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (text.compare(i, 2, "${") == 0) out += '$';  // escapes it: it is not a variable
    if (byte < 0x20 || byte == 0x7f) {
      out += std::string("\\x") + kHex[byte >> 4U] + kHex[byte & 15U];
      continue;
    }
    if (text[i] == '"' || text[i] == '\\') out += '\\';
    out += text[i];
  }
  return out + '"';
}

/// 010 is eight in YAML 1.1, ten in YAML 1.2.
bool hasLeadingZero(std::string_view text) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  return text.size() > 1 && text[0] == '0' && isDigit(text[1]);
}

/// Parses the whole text. from_chars() does not accept a plus sign.
template <class T>
std::errc parseAll(std::string_view text, T& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{}) return error;
  return stop == end ? std::errc{} : std::errc::invalid_argument;
}

/// nan and inf, with or without the dot of YAML.
bool isNotFinite(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of("+-."), text.size()));
  double value = 0;
  return parseAll(text, value) == std::errc{} && !std::isfinite(value);
}

Status refused(const std::string& expected, const std::string& text, const std::string& remedy) {
  return Status::invalidParameter("expects " + expected + ", not '" + text + "'" + remedy);
}

}  // namespace

Result<std::int64_t> readInteger(const std::string& text) {
  if (hasLeadingZero(text)) return refused("an integer", text, "; write it without leading zeros");
  std::int64_t value = 0;
  const std::errc error = parseAll(text, value);
  if (error == std::errc{}) return value;
  if (error == std::errc::result_out_of_range) {
    return refused("an integer of at most 64 bits", text, "");
  }
  double real = 0;
  const bool integral =
      parseAll(text, real) == std::errc{} && std::abs(real) < 1e15 && real == std::floor(real);
  const std::string digits = integral ? std::to_string(static_cast<std::int64_t>(real)) : "";
  return refused("an integer", text, integral ? "; write " + digits : "");
}

Result<double> readReal(const std::string& text) {
  if (hasLeadingZero(text)) return refused("a number", text, "; write it without leading zeros");
  double value = 0;
  const std::errc error = parseAll(text, value);
  const bool tiny = text.find("e-") != std::string::npos || text.find("E-") != std::string::npos;
  if (error == std::errc::result_out_of_range && tiny) {
    return refused("0 or a number of at least 1e-307", text, "; write 0");
  }
  if (error == std::errc::result_out_of_range || isNotFinite(text)) {
    return refused("a finite number", text, "");
  }
  if (error != std::errc{}) return refused("a number", text, "");
  return value;
}

Result<bool> readBool(const std::string& text) {
  if (text == "true") return true;
  if (text == "false") return false;
  static const std::array<std::string, 5> kTrue = {"yes", "on", "1", "y", "true"};
  static const std::array<std::string, 5> kFalse = {"no", "off", "0", "n", "false"};
  const auto means = [&](const std::string& word) { return editDistance(text, word) == 0; };
  std::string remedy;
  if (std::ranges::any_of(kTrue, means)) remedy = "; write true";
  if (std::ranges::any_of(kFalse, means)) remedy = "; write false";
  return refused("true or false", text, remedy);
}

std::string writeReal(double value) {
  const bool is_short_integer = value == std::floor(value) && std::abs(value) < 1e15 && value != 0;
  if (is_short_integer) return std::to_string(static_cast<std::int64_t>(value));
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  std::string text(digits.data(), end);
  // In YAML 1.1 "5e-04" is a text.
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos) {
    text.insert(exponent, ".0");
  }
  return text;
}

std::string writeText(const std::string& text) { return isPlainWord(text) ? text : quoted(text); }

Result<std::string> resolvePath(const std::string& path, const Origin& origin,
                                const BaseFolders& folders) {
  if (path.empty()) return path;
  std::filesystem::path absolute = path;
  if (path == "~" || path.starts_with("~/")) {
    if (folders.home.empty()) return Status::invalidParameter("'~' needs HOME, which is not set");
    absolute = folders.home + path.substr(1);
  } else if (path.starts_with('~')) {
    return Status::invalidParameter("'" + path +
                                    "': only '~/' is supported, not the home of another user");
  }
  std::filesystem::path base = folders.working_directory;
  if (origin.kind == Origin::Kind::File) {
    base /= std::filesystem::path(origin.file).parent_path();
  }
  std::string normal = (base / absolute).lexically_normal().string();
  while (normal.size() > 1 && normal.ends_with('/')) normal.pop_back();
  return normal;
}

std::string absence(const std::filesystem::path& path, const std::string& missing) {
  std::error_code ignored;
  const int reading = R_OK | (std::filesystem::is_directory(path, ignored) ? X_OK : 0);
  if (::access(path.c_str(), reading) == 0 || errno != EACCES) return missing;
  return "permission denied; let this user read it, and enter the folders above it (`chmod u+rX`)";
}

}  // namespace tolman::config
