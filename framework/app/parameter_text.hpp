// SPDX-License-Identifier: BSD-3-Clause
// A plugin's parameters for people and programs, from its declaration.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/library.hpp"

namespace tolman::app {

std::string parametersText(const host::LoadedPlugin& plugin);
std::string parametersMarkdown(const host::LoadedPlugin& plugin);
nlohmann::ordered_json parametersJson(const host::LoadedPlugin& plugin);

/// "1 to 512", ">= 0", "forward, backward", or nothing.
std::string limitsText(const ParameterInfo& info);

}  // namespace tolman::app
