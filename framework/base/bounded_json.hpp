// SPDX-License-Identifier: BSD-3-Clause
// Reads JSON that may be damaged or hostile.
#pragma once

#include <nlohmann/json.hpp>
#include <utility>

namespace tolman::bounded_json {

/// Nothing that is written here is deeper than ten levels.
inline constexpr int kDeepest = 100;

/// The value; Json::value_t::discarded for text that is no JSON or is nested deeper than kDeepest.
/// The library itself parses any depth, but copies and writes values by recursion, which ends the
/// program at some ten thousand levels.
template <class Json, class Input>
Json parse(Input&& input) {
  bool is_deep = false;
  const auto isShallow = [&](int depth, typename Json::parse_event_t, Json&) {
    is_deep = is_deep || depth > kDeepest;
    return depth <= kDeepest;
  };
  Json json = Json::parse(std::forward<Input>(input), isShallow, false);
  if (is_deep) return Json(Json::value_t::discarded);
  return json;
}

}  // namespace tolman::bounded_json
