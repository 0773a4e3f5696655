// SPDX-License-Identifier: BSD-3-Clause
// From a recorded run to its result files: trajectories, map, metrics, digests.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "config/settings.hpp"
#include "record/run_reader.hpp"
#include "report/run_data.hpp"
#include "tolman/status.hpp"

namespace tolman::run {

/// The data of the result files, for the report.
struct Results {
  std::unique_ptr<record::RunReader> reader;
  report::RunData data;
};

/// Writes trajectory.*, odometry.*, map.g2o, metrics.json, map.svg and results.sha256 into
/// `directory`, from run.sqlite alone. `seed`: seed of the run, for the scores by chance.
Result<Results> writeResults(const std::filesystem::path& directory,
                             const config::EvaluationSettings& settings, std::uint64_t seed);

}  // namespace tolman::run
