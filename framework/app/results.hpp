// SPDX-License-Identifier: BSD-3-Clause
// From a recorded run to its result files: trajectories, map, metrics, digests.
#pragma once

#include <filesystem>
#include <memory>

#include "config/settings.hpp"
#include "record/run_reader.hpp"
#include "report/run_data.hpp"
#include "tolman/status.hpp"

namespace tolman::app {

/// What the files were made from, for who goes on with it.
struct Results {
  std::unique_ptr<record::RunReader> reader;
  report::RunData data;
};

/// From run.sqlite alone writes trajectory.*, odometry.*, map.g2o, metrics.json, map.svg and
/// results.sha256 into `directory`.
Result<Results> writeResults(const std::filesystem::path& directory,
                             const config::EvaluationSettings& settings);

}  // namespace tolman::app
