// SPDX-License-Identifier: BSD-3-Clause
// YAML text to a tree of nodes: the only place that knows yaml-cpp.
#pragma once

#include <optional>
#include <string>

#include "config/node.hpp"

namespace tolman::config {

/// Reads one YAML document; an empty one gives a Null node. `source` is the origin of all values;
/// line and column are filled in where it is a file.
///
/// Stricter than yaml-cpp: duplicate keys are problems, the first stays; merge keys, tags, keys
/// that are no scalars, unclosed quotes, control characters, more than one document, nesting below
/// 32 levels and more than 20000 values (aliases counted as copies) are refused with a problem and
/// give nothing. Never throws for any bytes.
std::optional<Node> readYaml(const std::string& text, const Origin& source, Problems& problems);

}  // namespace tolman::config
