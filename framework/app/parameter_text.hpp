// SPDX-License-Identifier: BSD-3-Clause
// A plugin's parameters for people and programs, from its declaration.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/library.hpp"

namespace tolman::app {

std::string parametersText(const host::LoadedPlugin& plugin);
std::string parametersMarkdown(const host::LoadedPlugin& plugin);
nlohmann::ordered_json parametersJson(const host::LoadedPlugin& plugin);

/// JSON Schema (draft 2020-12) of a configuration file, for editors: the host's sections, and in
/// each stage these plugins of its role, selected by `plugin`. A file that `extends` another needs
/// no complete stages.
nlohmann::ordered_json fileSchema(const std::vector<host::LoadedPlugin>& plugins);

}  // namespace tolman::app
