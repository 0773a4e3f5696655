// SPDX-License-Identifier: BSD-3-Clause
// The files that plugins are made of, compared between two run.json.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tolman/roles.hpp"

namespace tolman::run {

/// Files of one plugin that have other contents, or are used in only one of the runs (whatever
/// their folder): its library, its program, the modules that this imports, and libraries that it
/// brings along. `before` and `now` are entries of "plugins" in run.json.
std::vector<std::string> changedProgramFiles(const nlohmann::ordered_json& before,
                                             const nlohmann::ordered_json& now);

/// Those of the stages with these roles, each of which a run has once. `before` and `now` are the
/// contents of run.json; in `before` anything may be missing or of another type.
std::vector<std::string> changedProgramFiles(const nlohmann::ordered_json& before,
                                             const nlohmann::ordered_json& now,
                                             std::initializer_list<Role> roles);

}  // namespace tolman::run
