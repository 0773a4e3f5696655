// SPDX-License-Identifier: BSD-3-Clause
// The value of an enumeration by its name; the reverse of enumName().
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

#include "tolman/fields.hpp"

namespace tolman {

/// None if no value has this name.
template <NamedEnum E>
std::optional<E> valueNamed(std::string_view name) {
  const std::span<const std::string_view> names = enumNames(E());
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<E>(found - names.begin());
}

}  // namespace tolman
