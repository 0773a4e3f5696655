// SPDX-License-Identifier: BSD-3-Clause
// The folder of one run of a sweep. It contains all about the run and its outcome:
//   config.yaml   the whole configuration, frozen when the run was planned
//   point.json    name, factors, key, digests of the inputs, the run whose answers it takes
//   run/          the run directory
//   outcome.json  written when the run has ended, unless it was interrupted; has the digests of
//                 its figures, so that those of another run are not taken for them
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
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
/// Folders of the last plan; empty where there is no points.txt.
std::vector<std::string> planOrder(const std::filesystem::path& sweep);

/// A run that was done and whose metrics.json, results.sha256 or files that this lists are not
/// those that it wrote has failed: its files were changed, or belong to another run.
PointOutcome outcomeOf(const std::filesystem::path& folder);
Status writeOutcome(const std::filesystem::path& folder, const PointOutcome& outcome);

}  // namespace tolman::experiment
