// SPDX-License-Identifier: BSD-3-Clause
// Values from the command line: --set a.b=c.
#pragma once

#include <string>
#include <vector>

#include "config/node.hpp"
#include "config/variables.hpp"

namespace tolman::config {

/// Puts each "path=value" into the tree. Parts of a path are keys, or indices of a list
/// ("observers.0.port=1"; the index after the last appends). The value is YAML: a scalar, or
/// [1, 2] or {plugin: x}. Assignments of plugins go first, since another plugin drops the
/// parameters that the files gave to the old one; otherwise the later wins.
void applyOverrides(Node& tree, const std::vector<std::string>& overrides,
                    const Environment& environment, Problems& problems);

}  // namespace tolman::config
