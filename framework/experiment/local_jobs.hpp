// SPDX-License-Identifier: BSD-3-Clause
// Runs the frozen runs of a sweep as local processes, several at a time.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiment/point_folder.hpp"
#include "tolman/context.hpp"

namespace tolman::experiment {

struct LocalJobsOptions {
  std::size_t jobs = 1;
  std::vector<std::string> command;  ///< the program and its arguments; a folder is appended
};

/// State of all runs, for a display.
struct JobsState {
  std::size_t all = 0;
  std::size_t ended = 0;
  std::size_t failed = 0;
  std::size_t lost = 0;              ///< done, but with lostTracking()
  double seconds = 0;                ///< since the start
  std::vector<std::string> running;  ///< names of the runs
};

class JobsListener {
 public:
  virtual ~JobsListener() = default;
  /// Called several times a second.
  virtual void onState(const JobsState& state) = 0;
  virtual void onEnd(const PlannedRun& run, const PointOutcome& outcome,
                     const JobsState& state) = 0;
};

/// Runs all of `runs` in their order, except that a run waits for the runs whose answers it takes.
/// A failed run does not stop the others; a process that crashes is a failed run. On cancellation
/// the processes are interrupted. If this process is killed, they are killed as well. Returns the
/// final state.
JobsState runLocally(const std::filesystem::path& sweep, const std::vector<PlannedRun>& runs,
                     const LocalJobsOptions& options, const Cancellation& cancellation,
                     JobsListener& listener);

}  // namespace tolman::experiment
