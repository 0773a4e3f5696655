// SPDX-License-Identifier: BSD-3-Clause
// The folder of a sweep: points.txt, the runs of the last plan in its order; data.json, digests of
// the data; and one folder per run:
//   config.yaml   the whole configuration, frozen when the run was planned
//   point.json    name, factors, key, digests of the inputs, the run whose answers it takes
//   run/          the run directory
//   outcome.json  written when the run has ended, unless it was interrupted
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiment/planner.hpp"
#include "tolman/status.hpp"

namespace tolman::experiment {

enum class PointState : std::uint8_t { Planned, Running, Interrupted, Done, Failed };
inline constexpr std::array<std::string_view, 5> kPointStateNames = {
    "planned", "running", "interrupted", "done", "failed"};
constexpr std::span<const std::string_view> enumNames(PointState) { return kPointStateNames; }

struct PointOutcome {
  PointState state = PointState::Planned;
  int exit_code = 0;
  std::string message;
  double wall_s = 0;
  bool replayed = false;  ///< took the answers of another run

  /// Done, but odometry was lost at the end or found no motion (exit code 6 of a run).
  bool lostTracking() const { return state == PointState::Done && exit_code != 0; }
};

/// Writes config.yaml and point.json below `sweep`. Existing ones are kept: a frozen run does not
/// change.
Status freeze(const std::filesystem::path& sweep, const PlannedRun& run);

/// A frozen run, without its configuration.
Result<PlannedRun> readPoint(const std::filesystem::path& folder);
/// The frozen runs of a sweep's folder.
struct FrozenRuns {
  std::vector<PlannedRun> planned;   ///< runs of the last plan in its order; all without points.txt
  std::vector<PlannedRun> earlier;   ///< runs only of earlier plans, by folder
  std::vector<std::string> missing;  ///< folders of the last plan without a readable point.json
  bool empty() const { return planned.empty() && earlier.empty() && missing.empty(); }
};
FrozenRuns frozenRuns(const std::filesystem::path& sweep);

/// Writes points.txt: the runs of the current plan, in its order.
Status writePlanOrder(const std::filesystem::path& sweep, const std::vector<PlannedRun>& runs);

/// Planned again if it was done and its run directory was removed.
PointOutcome outcomeOf(const std::filesystem::path& folder);
Status writeOutcome(const std::filesystem::path& folder, const PointOutcome& outcome);

/// Digests of the input data, by path, so that data that have not changed are read once.
std::map<std::string, record::DataDigest> readKnownData(const std::filesystem::path& sweep);
Status writeKnownData(const std::filesystem::path& sweep,
                      const std::map<std::string, record::DataDigest>& data);

/// Writes the files that repeat a sweep on another machine into `folder`, which must be empty or
/// new:
///   rerun.sh     repeats all runs that are done, and compares the results byte for byte
///   data.txt     one line per input: variable, path, SHA-256 (or digest of sizes and times)
///   results.csv  the table of `tolman sweep collect`
///   runs/NAME/   config.resolved.yaml, run.json, metrics.json, results.sha256, point.json
///
/// In the configurations the paths of data are variables, with the present path as default.
Status writeSweepArchive(const std::filesystem::path& sweep, const std::filesystem::path& folder);

}  // namespace tolman::experiment
