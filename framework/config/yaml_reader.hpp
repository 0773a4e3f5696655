// SPDX-License-Identifier: BSD-3-Clause
// Parses YAML text into a tree of nodes. Only this file uses yaml-cpp.
#pragma once

#include <optional>
#include <string>

#include "config/node.hpp"

namespace tolman::config {

/// Reads one YAML document; an empty one gives a Null node. `source` is the origin of all values;
/// line and column are filled in where it is a file.
///
/// Stricter than yaml-cpp: of duplicate keys the first is kept and the others are problems. Merge
/// keys, tags, keys that are not scalars, unclosed quotes, control characters, several documents,
/// more than 32 levels and more than 20000 values (aliases count as copies) are problems and give
/// no tree. Does not throw for any input.
std::optional<Node> readYaml(const std::string& text, const Origin& source, Problems& problems);

}  // namespace tolman::config
