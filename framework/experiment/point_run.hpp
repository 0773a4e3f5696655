// SPDX-License-Identifier: BSD-3-Clause
// Runs one frozen run of a sweep, in this process.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/run.hpp"
#include "experiment/point_folder.hpp"

namespace tolman::experiment {

struct PointRunOptions {
  std::vector<std::string> plugin_paths;
  std::vector<std::string> command_line;  ///< for run.json
  bool retry = false;                     ///< run it again when it failed
  bool quiet = false;
  int threads = 0;  ///< replaces `threads: 0` of the configuration
  std::function<std::string(const std::string&)> find_config;
  std::function<int(const engine::Outcome&)> exit_code;
  std::function<int(const engine::Failure&)> failure_code;
};

/// The outcome of the run; also if it had ended before. An interrupted run has the state
/// Interrupted and no outcome.json.
PointOutcome runPoint(const std::filesystem::path& folder, const PointRunOptions& options,
                      const Cancellation& cancellation);

}  // namespace tolman::experiment
