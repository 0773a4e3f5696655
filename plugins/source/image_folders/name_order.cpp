// SPDX-License-Identifier: BSD-3-Clause
#include "name_order.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "exact_decimal.hpp"
#include "hexadecimal_names.hpp"
#include "image_name.hpp"

namespace tolman::image_folders {
namespace {

using Indices = std::vector<std::size_t>;
using Reading = NameOrder::Reading;

template <typename Less>
Indices sortedBy(std::size_t count, const Less& isLess) {
  Indices order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, isLess);
  return order;
}

Indices naturally(const std::vector<std::string>& stems) {
  return sortedBy(stems.size(),
                  [&](std::size_t a, std::size_t b) { return naturalLess(stems[a], stems[b]); });
}

Indices byNumbers(const std::vector<ImageName>& names) {
  return sortedBy(names.size(), [&](std::size_t a, std::size_t b) {
    if (names[a].key != names[b].key) return names[a].key < names[b].key;
    return naturalLess(names[a].stem, names[b].stem);
  });
}

/// Whether each `separator` between digits may separate thousands: one to three digits without
/// leading zero, then groups of three. "cam1_999" and "cam1_1000" have counts of another kind.
bool separatesThousands(const std::vector<std::string>& stems, char separator) {
  const auto isOther = [separator](const std::string& stem) {
    const std::string without = withoutThousands(stem, separator);
    for (std::size_t at = 1; at + 1 < without.size(); ++at) {
      if (without[at] == separator && isDigit(without[at - 1]) && isDigit(without[at + 1])) {
        return true;
      }
    }
    const std::size_t at = stem.find(separator, stem.find_first_of("0123456789"));
    if (without == stem || at == std::string::npos) return false;
    std::size_t first = at;
    while (first > 0 && isDigit(stem[first - 1])) --first;
    return at - first > 3 || stem[first] == '0';
  };
  return std::ranges::none_of(stems, isOther);
}

/// The order if commas before three digits, or other separators, separate thousands; equal numbers
/// as in `stems`.
Indices byThousands(const std::vector<std::string>& stems) {
  std::vector<std::string> without;
  for (const std::string& stem : stems) without.push_back(withPlainSeparators(stem));
  const std::vector<std::string> plain = without;
  for (const char separator : {',', '_', ' ', '\'', '.'}) {
    if (separator != ',' && !separatesThousands(plain, separator)) continue;
    for (std::string& stem : without) stem = withoutThousands(stem, separator);
  }
  return sortedBy(stems.size(), [&](std::size_t a, std::size_t b) {
    return without[a] != without[b] ? naturalLess(without[a], without[b])
                                    : naturalLess(stems[a], stems[b]);
  });
}

/// Where more than half of the names are numbers as a whole, "1e-5" is one with an exponent.
std::vector<ImageName> parseAll(const std::vector<std::string>& stems, bool hexadecimal) {
  const auto numbers = std::ranges::count_if(
      stems, [](const std::string& stem) { return parseExactDecimal(stem).has_value(); });
  const bool numeric = !hexadecimal && 2 * numbers > std::ssize(stems);
  std::vector<ImageName> names;
  names.reserve(stems.size());
  for (const std::string& stem : stems) names.push_back(parseImageName(stem, numeric));
  return names;
}

/// The order if a dash behind a letter is a sign where other names lack it ("t-1.5", "t0.5"); empty
/// if there are no such names.
Indices bySigns(const std::vector<std::string>& stems) {
  std::vector<std::string> apart;
  for (const std::string& stem : stems) apart.push_back(withSignsApart(stem));
  const auto isNegative = [](const std::string& stem) {
    const std::size_t digit = stem.find_first_of("0123456789");
    return digit != std::string::npos && stem.substr(0, digit).ends_with("_-");
  };
  const auto negative = std::ranges::count_if(apart, isNegative);
  if (negative == 0 || negative == std::ssize(apart)) return {};
  return byNumbers(parseAll(apart, false));
}

std::optional<NameOrder::Pair> firstSame(const std::vector<ImageName>& names,
                                         const Indices& sorted) {
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const ImageName& before = names[sorted[i - 1]];
    const ImageName& here = names[sorted[i]];
    if (before.stem != here.stem && before.key == here.key) {
      return NameOrder::Pair(sorted[i - 1], sorted[i]);
    }
  }
  return std::nullopt;
}

/// Whether only some of the names have digits joined by several points.
bool hasSomeVersions(const std::vector<ImageName>& names) {
  const auto versions = std::ranges::count_if(names, &ImageName::has_version);
  return versions > 0 && versions < std::ssize(names);
}

std::optional<NameOrder::Pair> firstExchanged(const Indices& taken, const Indices& other) {
  const auto [here, there] = std::ranges::mismatch(taken, other);
  if (here == taken.end()) return std::nullopt;
  return NameOrder::Pair(*here, *there);
}

/// Names of another text than that which more than half of the names have.
Indices straysAmong(const std::vector<ImageName>& names) {
  std::map<std::string, std::size_t> counts;
  for (const ImageName& name : names) ++counts[name.text];
  const auto usual = std::ranges::max_element(counts, {}, [](const auto& of) { return of.second; });
  Indices strays;
  if (usual == counts.end() || 2 * usual->second <= names.size()) return strays;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].text != usual->first) strays.push_back(i);
  }
  return strays;
}

}  // namespace

NameOrder orderNames(const std::vector<std::string>& stems) {
  const Indices natural = naturally(stems);
  const Indices hexadecimal = hexadecimalOrder(stems);
  const bool is_hexadecimal = !hexadecimal.empty() && hexadecimal != natural;
  const std::vector<ImageName> names = parseAll(stems, is_hexadecimal);
  const Indices numbers = byNumbers(names);
  NameOrder order;
  order.same = firstSame(names, numbers);
  if (hexadecimal.empty()) order.strays = straysAmong(names);
  if (is_hexadecimal) {
    order.reading = Reading::Hexadecimal;
    order.indices = hexadecimal;
    order.doubt = firstExchanged(hexadecimal, natural);
    return order;
  }
  const bool by_numbers = numbers != natural && !order.same && !hasSomeVersions(names);
  order.reading = by_numbers ? Reading::Numbers : Reading::Natural;
  order.indices = by_numbers ? numbers : natural;
  order.doubt = firstExchanged(order.indices, by_numbers ? natural : numbers);
  if (!order.doubt) order.doubt = firstExchanged(order.indices, byThousands(stems));
  const Indices signs = bySigns(stems);
  if (!order.doubt && !signs.empty()) order.doubt = firstExchanged(order.indices, signs);
  return order;
}

}  // namespace tolman::image_folders
