// SPDX-License-Identifier: BSD-3-Clause
// What a run was made of and by: the contents of run.json.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/assembly.hpp"
#include "pipeline/run.hpp"

namespace tolman::app {

/// Versions, machine, seeds, command line, plugins with the SHA-256 of their files, data set.
nlohmann::ordered_json provenance(const CheckedSystem& system, const SourceInfo& source,
                                  const std::vector<std::string>& command_line, int threads);

/// Adds how it ended: status text, exit code, counters.
void addOutcome(nlohmann::ordered_json& json, const pipeline::Outcome& outcome, ExitCode code);

/// Seconds since 1970, and the same as "2026-11-21T10:30:00Z".
std::int64_t utcSeconds();
std::string utcText(std::int64_t seconds);

}  // namespace tolman::app
