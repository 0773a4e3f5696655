// SPDX-License-Identifier: BSD-3-Clause
// Values from the command line: --set a.b=c.
#pragma once

#include <string>
#include <vector>

#include "config/node.hpp"
#include "config/variables.hpp"
#include "tolman/status.hpp"

namespace tolman::config {

/// Applies each "path=value" to the tree. Parts of a path are keys, or indices of a list
/// ("observers.0.port=1"; the index after the last one appends). The value is YAML: a scalar,
/// [1, 2] or {plugin: x}. Plugins are assigned first, because another plugin removes the parameters
/// of the old one; otherwise later overrides take precedence.
void applyOverrides(Node& tree, const std::vector<std::string>& overrides,
                    const Environment& environment, Problems& problems);

/// Sets one value by such a path, with its own origin. A map is merged into the map that is there,
/// unless it names another plugin.
Status setValue(Node& tree, const std::string& path, const Node& value);

}  // namespace tolman::config
