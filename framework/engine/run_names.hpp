// SPDX-License-Identifier: BSD-3-Clause
// Short, distinct names of run directories.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tolman::run {

/// The last part of each path, after removing last parts that all paths have in common: "a" and "b"
/// for sweeps/a/run and sweeps/b/run. If two names are equal, earlier parts are added, joined by
/// '-', until all differ. A directory that is given twice gets a number.
std::vector<std::string> distinctNames(const std::vector<std::filesystem::path>& runs);

}  // namespace tolman::run
