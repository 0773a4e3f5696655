// SPDX-License-Identifier: BSD-3-Clause
// The states of the stages as files, and the JSON file beside them that describes them: plugin,
// version and parameters of each stage, and the digest of its state.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/assembly.hpp"

namespace tolman::run {

/// The states of those of place, cells and map that can save one.
Result<std::map<Role, std::string>> savedStates(Assembly& assembly);

/// Writes PREFIXstage.bin for each state, and then `file`: `contents` with the description of the
/// states and the id of the run in whose folder `state` they are. Each file is written atomically.
Status writeStates(Assembly& assembly, const std::filesystem::path& file, const std::string& prefix,
                   const std::map<Role, std::string>& states, nlohmann::ordered_json contents);

/// The JSON that writeStates() wrote into `file`. Throws Failed, also if it is of another run.
nlohmann::ordered_json readContents(const std::filesystem::path& file);

/// Loads the states of place, cells and map into a new assembly. Throws Failed if a state is
/// missing or damaged, or if plugin, version or parameters of a stage differ; and exceptions of
/// nlohmann if `contents` does not have the shape that writeStates() writes.
void loadStates(Assembly& assembly, const std::filesystem::path& file, const std::string& prefix,
                const nlohmann::ordered_json& contents);

}  // namespace tolman::run
