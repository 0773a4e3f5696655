// SPDX-License-Identifier: BSD-3-Clause
// The contents of run.json: configuration, versions, machine and outcome of a run.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/assembly.hpp"
#include "engine/run_counters.hpp"

namespace tolman::run {

/// Versions, machine, seeds, command line, plugins with the SHA-256 of their files, data set, raw
/// cameras, and how their images were rectified and cut.
nlohmann::ordered_json provenance(const Assembly& assembly,
                                  const std::vector<std::string>& command_line);

nlohmann::ordered_json countersJson(const pipeline::RunCounters& counters);

struct Outcome;  // run.hpp

/// Adds how the run ended: failure, counters, times of finish().
void addOutcome(nlohmann::ordered_json& json, const Outcome& outcome);

/// Seconds since 1970, and the same as "2026-11-21T10:30:00Z".
std::int64_t utcSeconds();
std::string utcText(std::int64_t seconds);

/// The id of a run with this run file: a digest of program, plugins, data and configuration, so
/// that runs that give the same results have the same id. A realtime run depends on the clock, and
/// has an id of its own.
std::string newRunId(nlohmann::ordered_json run_file, bool is_realtime);

}  // namespace tolman::run
