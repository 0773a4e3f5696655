// SPDX-License-Identifier: BSD-3-Clause
// A plugin's parameters for people and programs, from its declaration.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "plugins/library.hpp"

namespace tolman::app {

std::string parametersText(const plugins::LoadedPlugin& plugin);
std::string parametersMarkdown(const plugins::LoadedPlugin& plugin);
nlohmann::ordered_json parametersJson(const plugins::LoadedPlugin& plugin);

/// "1 to 512", ">= 0", "forward, backward", or nothing.
std::string limitsText(const ParameterInfo& info);
nlohmann::ordered_json valueJson(const ParameterValue& value);

}  // namespace tolman::app
