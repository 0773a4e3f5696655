// SPDX-License-Identifier: BSD-3-Clause
// Options of the command line whose values have names.
#pragma once

#include <algorithm>
#include <cctype>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace tolman::app {

/// For CLI::Validator: replaces a name, in any case of letters, by the number of its value; a text
/// that is none of the names is an error, which lists them.
template <class Value>
std::function<std::string(std::string&)> namedValue(
    std::vector<std::pair<std::string, Value>> names) {
  return [names = std::move(names)](std::string& text) -> std::string {
    std::string lower = text;
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
    std::string legal;
    for (const auto& [name, value] : names) {
      if (lower == name) {
        text = std::to_string(static_cast<int>(value));
        return "";
      }
      legal += (legal.empty() ? "" : ", ") + name;
    }
    return "'" + text + "' is none of " + legal;
  };
}

}  // namespace tolman::app
