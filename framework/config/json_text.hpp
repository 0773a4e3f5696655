// SPDX-License-Identifier: BSD-3-Clause
// JSON: as text, and integers from untrusted JSON.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace tolman::config {

/// Bytes that are not UTF-8, which names of files and texts of plugins may have, become U+FFFD.
/// `indent`: spaces of a level; -1 for everything on one line.
template <class Json>
std::string jsonText(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// The library's own get() converts any number, even 1e300. Throws Json::type_error if `json` is
/// not an integer or does not fit into T.
template <class T, class Json>
T integerFrom(const Json& json) {
  const auto checked = [&json](auto value) {
    if (std::in_range<T>(value)) return static_cast<T>(value);
    throw Json::type_error::create(302, "the number is too large", &json);
  };
  if (json.is_number_unsigned()) return checked(json.template get<std::uint64_t>());
  if (json.is_number_integer()) return checked(json.template get<std::int64_t>());
  throw Json::type_error::create(302, "type must be an integer", &json);
}

}  // namespace tolman::config
