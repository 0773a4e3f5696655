// SPDX-License-Identifier: BSD-3-Clause
// A sweep: its plan, runs with checked values; its folder, in which they are frozen; and how they
// are run. The folder has points.txt, the runs of the last plan in its order, and one folder per
// run:
//   config.yaml   the whole configuration, frozen when the run was planned
//   point.json    name, factors, key, digests of the inputs, the run whose answers it takes
//   run/          the run directory
//   outcome.json  written when the run has ended, unless it was interrupted
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "config/loader.hpp"
#include "engine/run.hpp"
#include "experiment/sweep_file.hpp"
#include "record/digest.hpp"
#include "tolman/context.hpp"
#include "tolman/status.hpp"

namespace tolman::experiment {

/// Digests of the inputs of a run besides its configuration.
struct Inputs {
  std::string host;                            ///< SHA-256 of the program
  std::map<std::string, std::string> plugins;  ///< by file
  std::vector<record::DataDigest> data;
};

/// One planned run. Its name, its number of threads, and `record.replay`, `record.report` and
/// `record.state_every` do not change its results and are not in the key.
struct PlannedRun {
  std::string name;
  std::string key;               ///< SHA-256 of everything that determines its results
  std::string folder;            ///< its name in the folder of the sweep
  std::string front_end_sha256;  ///< of all that determines answers of source, odometry and place
  std::vector<Factor> factors;
  std::string config;         ///< config.yaml; not known of frozen runs
  std::string config_sha256;  ///< of config.yaml when it was frozen
  Inputs inputs;
  std::string front_end_folder;  ///< folder of the front end that it replays, which must run before
  std::string answers_folder;  ///< folder of a run with the same front end, whose answers it takes
  bool keeps_answers = false;  ///< for other runs, which replay them
  bool is_front_end = false;

  /// The folder of the run that must end before it; empty for none.
  const std::string& needs() const {
    return front_end_folder.empty() ? answers_folder : front_end_folder;
  }
};

/// The frozen runs of a sweep's folder.
struct FrozenRuns {
  std::vector<PlannedRun> planned;   ///< runs of the last plan in its order; all without points.txt
  std::vector<PlannedRun> earlier;   ///< runs only of earlier plans, by folder
  std::vector<std::string> missing;  ///< folders of the last plan without a readable point.json
  bool empty() const { return planned.empty() && earlier.empty() && missing.empty(); }
};
FrozenRuns frozenRuns(const std::filesystem::path& sweep);

/// Finds a shipped file by its name.
using FindConfig = std::function<std::string(const std::string&)>;

struct PlanOptions {
  std::vector<std::string> plugin_paths;
  std::filesystem::path out;  ///< folder of the sweep
  FrozenRuns frozen;          ///< what it holds: data that have not changed are not read again
  FindConfig find_config;
  config::FindShipped find_shipped;  ///< for `extends`
  config::Environment environment;
};

struct Plan {
  std::string name;
  std::vector<PlannedRun> runs;                    ///< front ends first
  config::Problems problems;                       ///< if there are any, do not use the runs
  std::map<std::string, record::DataDigest> data;  ///< by path
  std::set<std::string> missing;                   ///< paths of sources that do not exist
};

Plan makePlan(const std::filesystem::path& file, const PlanOptions& options);

/// Writes config.yaml and point.json of each of `todo` that has none, because a frozen run does not
/// change, and points.txt of all runs of the plan.
Status freeze(const std::filesystem::path& sweep, const std::vector<PlannedRun>& todo,
              const std::vector<PlannedRun>& plan);

/// A frozen run, without its configuration.
Result<PlannedRun> readPoint(const std::filesystem::path& folder);

enum class PointState : std::uint8_t { Planned, Running, Interrupted, Done, Failed };
inline constexpr std::array<std::string_view, 5> kPointStateNames = {
    "planned", "running", "interrupted", "done", "failed"};
constexpr std::span<const std::string_view> enumNames(PointState) { return kPointStateNames; }

struct PointOutcome {
  PointState state = PointState::Planned;
  int exit_code = 0;
  std::string message{};
  double wall_s = 0;
  bool replayed = false;  ///< took the answers of another run

  /// Done, but odometry was lost at the end or found no motion (exit code 6 of a run).
  bool lostTracking() const { return state == PointState::Done && exit_code != 0; }
};

/// Planned again if it was done and its run directory was removed.
PointOutcome outcomeOf(const std::filesystem::path& folder);
Status writeOutcome(const std::filesystem::path& folder, const PointOutcome& outcome);

struct PointRunOptions {
  std::vector<std::string> plugin_paths;
  std::vector<std::string> command_line;  ///< for run.json
  bool quiet = false;
  int threads = 0;  ///< replaces `threads: 0` of the configuration
  FindConfig find_config;
  std::function<int(const engine::Outcome&)> exit_code;
  std::function<int(const engine::Failure&)> failure_code;
};

/// Runs one frozen run in this process, and before it the run that it needs. The outcome; also if
/// it had ended before. An interrupted run has the state Interrupted and no outcome.json.
PointOutcome runPoint(const std::filesystem::path& folder, const PointRunOptions& options,
                      const Cancellation& cancellation);

/// State of all runs, for a display.
struct JobsState {
  std::size_t all = 0;
  std::size_t ended = 0;
  std::size_t failed = 0;
  std::size_t lost = 0;              ///< done, but with lostTracking()
  double seconds = 0;                ///< since the start
  double left_s = -1;                ///< forecast; -1: not known yet
  std::vector<std::string> running;  ///< names of the runs
};

struct LocalJobsOptions {
  std::size_t jobs = 1;
  std::vector<std::string> command;  ///< the program and its arguments; a folder is appended
  std::function<void(const JobsState&)> on_state;  ///< called several times a second
  std::function<void(const PlannedRun&, const PointOutcome&, const JobsState&)> on_end;
};

/// Runs all of `runs` as processes, in their order, except that a run waits for the runs whose
/// answers it takes. A failed run does not stop the others; a process that crashes is a failed run.
/// On cancellation the processes are interrupted. Returns the final state.
JobsState runLocally(const std::filesystem::path& sweep, const std::vector<PlannedRun>& runs,
                     const LocalJobsOptions& options, const Cancellation& cancellation);

}  // namespace tolman::experiment
