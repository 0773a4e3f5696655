// SPDX-License-Identifier: BSD-3-Clause
#include "base/text_encoding.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tolman::text_encoding {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kLooked = 4096;  // bytes whose zeros are counted

/// UTF-16 or UTF-32, by where zero bytes are: in text of Latin letters and digits every second byte
/// is zero, at places of the same parity, or three of four are. Empty for neither.
std::string_view encodingByZeros(std::string_view text) {
  const std::string_view begin = text.substr(0, kLooked);
  std::array<std::size_t, 2> zeros{};  // at even and odd places
  for (std::size_t i = 0; i < begin.size(); ++i) zeros[i % 2] += begin[i] == '\0' ? 1 : 0;
  const std::size_t half = begin.size() / 2;
  const auto [fewer, more] = std::minmax(zeros[0], zeros[1]);
  if (half < 2 || more * 10 < half * 8) return "";
  if (fewer == 0) return "UTF-16";
  return fewer * 10 >= half * 4 && fewer * 10 <= half * 6 ? "UTF-32" : "";
}

std::string_view encodingByMark(std::string_view text) {
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  return text.starts_with("\xFF\xFE"sv) || text.starts_with("\xFE\xFF"sv) ? "UTF-16" : "";
}

}  // namespace

std::string encodingProblem(std::string_view text) {
  std::string_view encoding = encodingByMark(text);
  const std::size_t zero = text.find('\0');
  if (encoding.empty() && zero == std::string_view::npos) return "";
  if (encoding.empty()) encoding = encodingByZeros(text);
  if (!encoding.empty()) return "is " + std::string(encoding) + "; save it as UTF-8";
  const auto line = 1 + std::ranges::count(text.substr(0, zero), '\n');
  return "has a zero byte in line " + std::to_string(line) +
         ", so it is damaged or no text; restore it";
}

std::string_view withoutMark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.substr(text.starts_with(kMark) ? kMark.size() : 0);
}

}  // namespace tolman::text_encoding
