// SPDX-License-Identifier: BSD-3-Clause
// Which run a file belongs to. run.json has the id under "id", run.sqlite in table `run`,
// answers.bin in its first block, and the files that describe a saved state under "run"; so files
// of another run that were copied into a run directory are noticed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "tolman/status.hpp"

namespace tolman::record {

inline constexpr const char* kRunIdKey = "id";

/// The id that run.json there has. Empty where it has none, as in runs of older versions, or where
/// run.json is missing or damaged.
std::string runIdOf(const std::filesystem::path& directory);

/// InvalidInput, naming both files, if `file` in a run directory with the id `run` has another id.
/// An empty `run` allows any.
Status isOfRun(const std::filesystem::path& file, std::string_view id, std::string_view run);

}  // namespace tolman::record
