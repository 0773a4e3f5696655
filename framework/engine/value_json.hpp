// SPDX-License-Identifier: BSD-3-Clause
// The value of a parameter as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "tolman/parameters.hpp"

namespace tolman::run {

inline nlohmann::ordered_json valueJson(const ParameterValue& value) {
  return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

}  // namespace tolman::run
