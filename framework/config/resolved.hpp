// SPDX-License-Identifier: BSD-3-Clause
// A complete configuration as text: all values, configured or default.
#pragma once

#include <map>
#include <string>

#include "config/system_config.hpp"

namespace tolman::config {

/// Checked parameters by the name of the stage's instance.
using StageValues = std::map<std::string, ParameterValues, std::less<>>;

/// config.resolved.yaml: loading it gives the same values.
std::string resolvedYaml(const SystemConfig& config, const StageValues& values);

/// The same with the origin of each value in a comment, for `tolman check --explain`:
///   active_points: 2000                     # configs/a.yaml:4:13
std::string explain(const SystemConfig& config, const StageValues& values);

}  // namespace tolman::config
