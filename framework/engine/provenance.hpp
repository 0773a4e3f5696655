// SPDX-License-Identifier: BSD-3-Clause
// The contents of run.json: configuration, versions, machine and outcome of a run.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/chain.hpp"
#include "engine/checked_system.hpp"

namespace tolman::engine {

/// Versions, machine, seeds, command line, plugins with the SHA-256 of their files, data set, and
/// how its images were rectified and cut.
nlohmann::ordered_json provenance(const Assembly& assembly,
                                  const std::vector<std::string>& command_line);

nlohmann::ordered_json countersJson(const RunCounters& counters);

struct Outcome;  // run.hpp

/// Adds how the run ended: failure, counters, times of finish().
void addOutcome(nlohmann::ordered_json& json, const Outcome& outcome);

/// Files of the plugins with these roles that have other contents than before, or are used in only
/// one of the runs (whatever their folder): libraries, programs, and what they bring along.
/// `before` and `now` are the contents of run.json.
std::vector<std::string> changedProgramFiles(const nlohmann::ordered_json& before,
                                             const nlohmann::ordered_json& now,
                                             std::initializer_list<Role> roles);

/// Program files of all stages and data that have other contents than before.
std::vector<std::string> changedInputs(const nlohmann::ordered_json& before,
                                       const nlohmann::ordered_json& now);

/// The value of a parameter as JSON.
inline nlohmann::ordered_json valueJson(const ParameterValue& value) {
  return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

/// Seconds since 1970, and the same as "2026-11-21T10:30:00Z".
std::int64_t utcSeconds();
std::string utcText(std::int64_t seconds);

}  // namespace tolman::engine
