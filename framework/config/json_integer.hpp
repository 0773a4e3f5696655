// SPDX-License-Identifier: BSD-3-Clause
// Reads integers from untrusted JSON. The library's own get() converts any number, even 1e300.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace tolman::config {

/// Throws Json::type_error if `json` is not an integer or does not fit into T.
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
