// SPDX-License-Identifier: BSD-3-Clause
// One recorded run: from a checked system to the outcome. The stages are created and driven over
// all frames of the source, and everything is recorded in a run directory. Messages go only to the
// log that the caller passes, so any program can embed a run (docs/embed.md).
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/chain.hpp"
#include "engine/checked_system.hpp"
#include "engine/run_listener.hpp"
#include "evaluation/metrics.hpp"
#include "record/recorder.hpp"
#include "record/run_directory.hpp"
#include "record/run_reader.hpp"

namespace tolman::engine {

/// How a run ended. A failed or interrupted run also has counters, and figures of the frames that
/// were recorded. It has a directory unless it failed before the directory was made.
struct Outcome : DriveResult {
  std::filesystem::path directory;  ///< absolute; empty if the run failed before it was created
  std::optional<evaluation::Metrics> metrics;  ///< of the recorded frames, if there are any
  double wall_s = 0;  ///< s, from the start of the observers until run.sqlite is closed
};

struct RunOptions {
  std::filesystem::path out{};  ///< run directory; empty: runs/NAME-TIME in the working directory
  bool replace = false;         ///< replace an earlier run in `out`
  /// Directory of an interrupted or killed run to resume, instead of `out`. The system must be
  /// checked from its config.resolved.yaml. The results are those of a run without interruption,
  /// except for frames that a realtime run drops.
  std::filesystem::path resume{};
  std::vector<std::string> command_line{};  ///< for run.json
  /// Record the answers of the front end (source, odometry, place) as with record.replay, if the
  /// source has images.
  bool share_answers = false;
  /// The exit code of the program for an outcome, for run.json. Null: none is written.
  std::function<int(const Outcome&)> exit_code{};
};

class Run {
 public:
  /// The referenced objects must outlive this one. Cancellation ends the run between two frames.
  Run(RunLog& log, const Clock& clock, const Cancellation& cancellation, RunOptions options = {})
      : log_(log), clock_(clock), stop_(cancellation), options_(std::move(options)) {}

  /// Runs `system` to its end. Call it once.
  Outcome execute(CheckedSystem system);

 private:
  const config::SystemConfig& config() const { return assembly_->system().config; }
  bool localises() const { return !config().general.localise.empty(); }
  // prepare() and what it calls throw Failure.
  void prepare(CheckedSystem system);
  void checkOut(const std::string& continued) const;
  void continueEarlierRun();
  void resumeRun();
  void reopenRecord(nlohmann::ordered_json before, nlohmann::ordered_json now);
  void openDirectory();
  void openRecord();
  void recordSessions();
  void warnOfOthers(const std::vector<CameraRig>& before);

  void drive(Outcome& outcome);
  void warnOfSource(const DriveResult& result, RunListener& listener);
  std::optional<Failure> failureOf(const DriveResult& result);
  std::optional<Failure> saveState(const DriveResult& result, RunListener& listener);

  void conclude(Outcome& outcome);
  void writeResultFiles(Outcome& outcome);
  void completeRunFile(const Outcome& outcome);
  void failUnlessWritten(Outcome& outcome, const Status& written);

  RunLog& log_;
  const Clock& clock_;
  const Cancellation& stop_;
  RunOptions options_;
  std::unique_ptr<Assembly> assembly_;
  std::vector<std::string> inputs_;             ///< paths that the run reads
  std::vector<ArrayInfo> arrays_;               ///< descriptions for observers
  std::unique_ptr<record::RunReader> earlier_;  ///< the run that is continued, until it is copied
  std::int64_t first_frame_ = 0;
  std::optional<MapScale> earlier_scale_;  ///< of the run that is continued
  std::optional<ResumePoint> resume_;
  std::unique_ptr<record::RunDirectory> directory_;
  nlohmann::ordered_json run_file_;  ///< contents of run.json
  std::unique_ptr<record::Recorder> recorder_;
};

}  // namespace tolman::engine
