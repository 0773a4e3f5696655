// SPDX-License-Identifier: BSD-3-Clause
// JSON as text.
#pragma once

#include <string>

namespace tolman::config {

/// Bytes that are not UTF-8, which names of files and texts of plugins may have, become U+FFFD.
/// `indent`: spaces of a level; -1 for everything on one line.
template <class Json>
std::string jsonText(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tolman::config
