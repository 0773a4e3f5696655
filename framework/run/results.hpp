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

/// What the files were made from, for the report.
struct Results {
  std::unique_ptr<record::RunReader> reader;
  report::RunData data;
};

/// From run.sqlite alone writes trajectory.*, odometry.*, map.g2o, metrics.json, map.svg and
/// results.sha256 into `directory`. `seed`: of the run, for what chance gives.
Result<Results> writeResults(const std::filesystem::path& directory,
                             const config::EvaluationSettings& settings, std::uint64_t seed);

}  // namespace tolman::run
