// SPDX-License-Identifier: BSD-3-Clause
// Differences between two runs, from their run.json.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tolman::app {

// Both return one line for each difference, and throw Ended (5) if a run.json has values of other
// types than a run writes.

/// Differences that can change results: program, libraries, machine, seed, plugins and data.
std::vector<std::string> resultChanges(const std::filesystem::path& before,
                                       const std::filesystem::path& after);

/// Only differences of the data: digest where both run.json have one, number of files and bytes.
std::vector<std::string> dataChanges(const std::filesystem::path& before,
                                     const std::filesystem::path& after);

}  // namespace tolman::app
