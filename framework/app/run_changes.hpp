// SPDX-License-Identifier: BSD-3-Clause
// What two run.json say has changed between their runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tolman::app {

// One line each; both throw Ended (5) if a run.json has values of other types than a run writes.

/// Differences that can change results: program, libraries, machine, seed, plugins and data.
std::vector<std::string> resultChanges(const std::filesystem::path& before,
                                       const std::filesystem::path& after);

/// Only differences of the data: digest where both runs know it, number of files and bytes.
std::vector<std::string> dataChanges(const std::filesystem::path& before,
                                     const std::filesystem::path& after);

}  // namespace tolman::app
