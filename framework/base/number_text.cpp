// SPDX-License-Identifier: BSD-3-Clause
#include "base/number_text.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

namespace tolman::text_encoding {
namespace {

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

}  // namespace

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
