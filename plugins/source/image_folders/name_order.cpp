// SPDX-License-Identifier: BSD-3-Clause
#include "name_order.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

namespace tolman::image_folders {
namespace {

/// Removes the leading digits from `text` and returns them without leading zeros.
std::string_view takeNumber(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), isDigit);
  std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(number.size());
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

/// Negative, 0 or positive if a is before, equal to or after b; leading zeros are ignored.
int naturalOrder(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (isDigit(a.front()) && isDigit(b.front())) {
      const std::string_view number_a = takeNumber(a);
      const std::string_view number_b = takeNumber(b);
      if (number_a.size() != number_b.size()) return number_a.size() < number_b.size() ? -1 : 1;
      if (const int order = number_a.compare(number_b); order != 0) return order;
    } else {
      if (a.front() != b.front()) return a.front() < b.front() ? -1 : 1;
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return static_cast<int>(!a.empty()) - static_cast<int>(!b.empty());
}

/// A number of any length: digits of the whole part without leading zeros, and of the fraction
/// without trailing zeros.
struct NumberInName {
  std::string_view text_before;
  std::string_view whole;
  std::string_view fraction;
  bool has_point = false;

  auto value() const { return std::tuple(whole.size(), whole, fraction); }
};

std::optional<NumberInName> numberInName(std::string_view name) {
  NumberInName decimal;
  const auto first = std::find_if(name.begin(), name.end(), isDigit);
  decimal.text_before = name.substr(0, static_cast<std::size_t>(first - name.begin()));
  name.remove_prefix(decimal.text_before.size());
  if (name.empty()) return std::nullopt;
  decimal.whole = takeNumber(name);
  if (name.empty()) return decimal;
  decimal.has_point = true;
  decimal.fraction = name.substr(1);
  if (name.front() != '.' || decimal.fraction.empty() ||
      !std::all_of(decimal.fraction.begin(), decimal.fraction.end(), isDigit)) {
    return std::nullopt;
  }
  decimal.fraction = decimal.fraction.substr(0, decimal.fraction.find_last_not_of('0') + 1);
  return decimal;
}

}  // namespace

bool naturalLess(std::string_view a, std::string_view b) {
  const int order = naturalOrder(a, b);
  return order != 0 ? order < 0 : a < b;
}

bool sameButForZeros(std::string_view a, std::string_view b) { return naturalOrder(a, b) == 0; }

bool areDecimals(const std::vector<std::string>& names) {
  std::set<std::tuple<std::size_t, std::string_view, std::string_view>> values;
  std::optional<std::string_view> text_before;
  bool has_point = false;
  for (const std::string& name : names) {
    const std::optional<NumberInName> decimal = numberInName(name);
    if (!decimal || !values.insert(decimal->value()).second) return false;
    if (decimal->text_before != text_before.value_or(decimal->text_before)) return false;
    text_before = decimal->text_before;
    has_point = has_point || decimal->has_point;
  }
  return has_point;
}

bool decimalLess(std::string_view a, std::string_view b) {
  const std::optional<NumberInName> decimal_a = numberInName(a);
  const std::optional<NumberInName> decimal_b = numberInName(b);
  if (!decimal_a || !decimal_b) return decimal_a.has_value() < decimal_b.has_value();
  return decimal_a->value() < decimal_b->value();
}

}  // namespace tolman::image_folders
