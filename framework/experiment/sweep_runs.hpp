// SPDX-License-Identifier: BSD-3-Clause
// Runs the frozen runs of a sweep: one in this process, all as local processes, or by files for
// Slurm, GNU parallel and Snakemake.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/run.hpp"
#include "experiment/sweep_folder.hpp"
#include "tolman/context.hpp"

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

/// Writes into the folder of the sweep, by `kind`:
///   slurm      runs-1.txt and runs-2.txt, one folder per line; array.sh, which runs one of them;
///              submit.sh, which submits an array of each list, the second after the first
///   parallel   commands-1.txt, commands-2.txt: lists of commands, the second after the first
///   snakemake  Snakefile
/// Runs of the second list take answers of runs of the first. `command` runs one folder.
Result<std::vector<std::filesystem::path>> writeJobFiles(const std::filesystem::path& sweep,
                                                         const std::string& name,
                                                         const std::vector<PlannedRun>& runs,
                                                         const std::vector<std::string>& command,
                                                         const std::string& kind);

}  // namespace tolman::experiment
