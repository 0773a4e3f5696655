// SPDX-License-Identifier: BSD-3-Clause
// ${NAME} and ${NAME:-default} in values.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "config/node.hpp"

namespace tolman::config {

/// Looks up an environment variable.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;

/// The environment of this process.
Environment processEnvironment();

/// In all scalars below `node`, replaces ${NAME} by the variable, and ${NAME:-default} by the
/// default if the variable is unset or empty. $${ stands for ${. The result is not parsed as YAML
/// again and counts as unquoted: {port: "${PORT:-8080}"} is a number.
void expandVariables(Node& node, const std::string& path, const Environment& environment,
                     Problems& problems);

}  // namespace tolman::config
