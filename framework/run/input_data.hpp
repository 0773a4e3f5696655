// SPDX-License-Identifier: BSD-3-Clause
// The files that a configuration reads.
#pragma once

#include <string>
#include <vector>

#include "config/resolved.hpp"
#include "host/library.hpp"

namespace tolman::run {

/// Files and folders that parameters of the stages name, and the run that is continued; each once,
/// in order. A text that is the path of a file counts, too.
std::vector<std::string> inputPaths(const config::SystemConfig& config,
                                    const config::StageValues& values,
                                    const std::vector<const Schema*>& schemas);

}  // namespace tolman::run
