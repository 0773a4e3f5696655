// SPDX-License-Identifier: BSD-3-Clause
// The states of the stages as files, and the JSON file beside them that describes them: plugin,
// version and parameters of each stage, and the digest of its state.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "run/assembly.hpp"

namespace tolman::run {

/// Of each of place, cells and map that can save its state.
Result<std::map<Role, std::string>> savedStates(Assembly& assembly);

/// Writes PREFIXstage.bin for each state, and at last `file`: `contents` with the description of
/// the states. Each file appears whole or not at all.
Status writeStates(Assembly& assembly, const std::filesystem::path& file, const std::string& prefix,
                   const std::map<Role, std::string>& states, nlohmann::ordered_json contents);

/// What writeStates() wrote into `file`. Throws Failed.
nlohmann::ordered_json readContents(const std::filesystem::path& file);

/// Loads the states of place, cells and map into a fresh assembly. Throws Failed where a state is
/// missing or damaged, or where a stage is not the one that saved it; and nlohmann's exceptions
/// where `contents` is not what writeStates() writes.
void loadStates(Assembly& assembly, const std::filesystem::path& file, const std::string& prefix,
                const nlohmann::ordered_json& contents);

}  // namespace tolman::run
