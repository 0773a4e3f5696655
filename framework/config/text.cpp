// SPDX-License-Identifier: BSD-3-Clause
#include "config/text.hpp"

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <cstdint>
#include <numeric>
#include <vector>

namespace tolman::config {
namespace {

char folded(char c) {
  if (c == '-') return '_';
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool sameLetter(char a, char b) { return folded(a) == folded(b); }

/// Control characters, and the two that XML forbids.
constexpr bool isControl(std::uint32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0xfffe || c == 0xffff;
}

}  // namespace

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);  // row i - 2 of the table, then i - 1, then i
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (sameLetter(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped =
          i > 1 && j > 1 && sameLetter(a[i - 1], b[j - 2]) && sameLetter(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

std::optional<std::string> nearestName(std::string_view name,
                                       std::span<const std::string> candidates) {
  std::optional<std::string> nearest;
  std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(name, candidate);
    const bool shares_letters = distance < std::min(name.size(), candidate.size());
    if (distance >= least || !shares_letters) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

std::string didYouMean(std::string_view name, std::span<const std::string> candidates) {
  const auto nearest = nearestName(name, candidates);
  return nearest ? "; did you mean '" + *nearest + "'?" : "";
}

std::string listed(std::span<const std::string> names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

bool isPrintable(std::string_view text) {
  return text.find_first_of("\n\t") == std::string_view::npos && printable(text, "") == text;
}

std::string printable(std::string_view text, std::string_view instead) {
  namespace utf = boost::locale::utf;
  std::string safe;
  safe.reserve(text.size());
  while (!text.empty()) {
    const char* next = text.data();
    const auto c = utf::utf_traits<char>::decode(next, text.data() + text.size());
    const bool is_character = c != utf::illegal && c != utf::incomplete;
    const std::size_t length =
        is_character ? static_cast<std::size_t>(next - text.data()) : std::size_t{1};
    const bool stays = is_character && (c == '\n' || c == '\t' || !isControl(c));
    safe.append(stays ? text.substr(0, length) : instead);
    text.remove_prefix(length);
  }
  return safe;
}

}  // namespace tolman::config
