// SPDX-License-Identifier: BSD-3-Clause
#include "hexadecimal_names.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "exact_decimal.hpp"
#include "image_name.hpp"

namespace tolman::image_folders {
namespace {

struct HexadecimalName {
  std::string text;    ///< before the number
  std::string number;  ///< in lower case
};

HexadecimalName split(const std::string& stem) {
  std::size_t begin = stem.find_last_not_of("0123456789abcdefABCDEF") + 1;  // npos + 1 is 0
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const bool has_prefix =
      begin > 1 && (stem[begin - 1] == 'x' || stem[begin - 1] == 'X') && stem[begin - 2] == '0';
  if (begin > 0 && isLetter(stem[begin - 1]) && !has_prefix) {
    begin = std::min(stem.find_first_of("0123456789", begin), stem.size());
  }
  HexadecimalName name{stem.substr(0, begin), stem.substr(begin)};
  for (char& c : name.number) {
    if (c >= 'A' && c <= 'F') c = static_cast<char>(c - 'A' + 'a');
  }
  return name;
}

/// Whether it can be nothing else: "0a", but not "10", "1e5", "f1" or a word.
bool isSurely(const std::string& number) {
  const auto digit = std::ranges::find_if(number, isDigit);
  return !std::all_of(digit, number.end(), isDigit) && !parseExactDecimal(number);
}

/// Whether a name has the text of a number of `length` digits, but another length.
bool hasOtherLengths(const std::vector<HexadecimalName>& names, std::size_t length) {
  std::set<std::string> texts;
  for (const HexadecimalName& name : names) {
    if (name.number.size() == length) texts.insert(name.text);
  }
  return std::ranges::any_of(names, [&](const HexadecimalName& name) {
    return !name.number.empty() && name.number.size() != length && texts.contains(name.text);
  });
}

/// The most frequent length of the numbers; 0 unless that of more than half of the names.
std::size_t usualLength(const std::vector<HexadecimalName>& names) {
  std::map<std::size_t, std::size_t> counts;
  for (const HexadecimalName& name : names) ++counts[name.number.size()];
  const auto usual = std::ranges::max_element(counts, {}, [](const auto& of) { return of.second; });
  return usual != counts.end() && 2 * usual->second > names.size() ? usual->first : 0;
}

}  // namespace

std::vector<std::size_t> hexadecimalOrder(const std::vector<std::string>& stems) {
  std::vector<HexadecimalName> names;
  names.reserve(stems.size());
  for (const std::string& stem : stems) names.push_back(split(stem));
  const std::size_t length = usualLength(names);
  if (length < 2 || hasOtherLengths(names, length)) return {};
  bool any = false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].number.size() != length) names[i] = {stems[i], ""};
    any = any || isSurely(names[i].number);
  }
  if (!any) return {};
  std::vector<std::size_t> order(stems.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    if (names[a].text != names[b].text) return naturalLess(names[a].text, names[b].text);
    if (names[a].number != names[b].number) return names[a].number < names[b].number;
    return stems[a] < stems[b];
  });
  return order;
}

}  // namespace tolman::image_folders
