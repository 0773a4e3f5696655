// SPDX-License-Identifier: BSD-3-Clause
// The files that a configuration reads.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "config/system_config.hpp"
#include "engine/checked_system.hpp"
#include "host/library.hpp"

namespace tolman::engine {

/// What the plugins of the stages declare, by the name of the stage; not of stages without a
/// plugin.
using StageSchemas = std::map<std::string, const Schema*, std::less<>>;

/// Files and folders that parameters of the stages name, and the run that is continued; each once,
/// in order. A text parameter that is the path of a file counts as well.
std::vector<std::string> inputPaths(const config::SystemConfig& config,
                                    const config::StageValues& values, const StageSchemas& schemas);

/// The inputPaths() of a system that is about to run.
std::vector<std::string> inputPaths(const CheckedSystem& system);

/// Paths of the source that do not exist (yet), and that of the run to continue. A run that reads
/// one of them will fail.
std::set<std::string> missingPaths(const config::SystemConfig& config,
                                   const config::StageValues& values, const StageSchemas& schemas);

}  // namespace tolman::engine
