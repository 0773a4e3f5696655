// SPDX-License-Identifier: BSD-3-Clause
// Expansion of environment variables.
#include <algorithm>
#include <cstdlib>

#include "config/loader.hpp"
#include "config/text.hpp"

namespace tolman::config {
namespace {

bool isName(std::string_view name) {
  const auto inner = [](char c) { return isLetter(c) || isDigit(c) || c == '_'; };
  return !name.empty() && !isDigit(name.front()) && std::ranges::all_of(name, inner);
}

/// The value for the text between the braces. Adds the name of the variable to `used`, and whether
/// the default is taken.
Result<std::string> lookUp(const std::string& inside, const Environment& environment,
                           std::string& used) {
  const std::size_t split = inside.find(":-");
  const bool has_default = split != std::string::npos;
  const std::string name = inside.substr(0, split);
  if (!isName(name)) {
    return Status::invalidParameter("'${" + inside +
                                    "}' is not a variable; write ${NAME} or "
                                    "${NAME:-default}, and $${ for the characters themselves");
  }
  if (inside.find("${") != std::string::npos) {
    return Status::invalidParameter("${" + name + ":-...} cannot contain another ${...}");
  }
  used += (used.empty() ? "" : ", ") + name;
  const std::optional<std::string> value = environment(name);
  if (value && !(value->empty() && has_default)) return *value;
  if (has_default) {
    used += value ? " (empty)" : " (not set)";
    return inside.substr(split + 2);
  }
  return Status::invalidParameter("the environment variable " + name +
                                  " is not set; set it or write ${" + name + ":-default}");
}

}  // namespace

Environment processEnvironment() {
  return [](const std::string& name) -> std::optional<std::string> {
    const char* value = std::getenv(name.c_str());
    return value != nullptr ? std::optional<std::string>(value) : std::nullopt;
  };
}

Result<std::string> expandVariables(const std::string& text, const Environment& environment,
                                    std::string& used) {
  std::string expanded;
  std::size_t done = 0;
  for (std::size_t start = text.find("${"); start != std::string::npos;
       start = text.find("${", done)) {
    expanded.append(text, done, start - done);
    if (start > done && text[start - 1] == '$') {  // escaped; one '$' is already there
      expanded += '{';
      done = start + 2;
      continue;
    }
    const std::size_t end = text.find('}', start);
    if (end == std::string::npos) return Status::invalidParameter("'${' without '}'");
    const auto value = lookUp(text.substr(start + 2, end - start - 2), environment, used);
    if (!value.isOk()) return value.status();
    expanded += value.value();
    done = end + 1;
  }
  return expanded + text.substr(done);
}

}  // namespace tolman::config
