// SPDX-License-Identifier: BSD-3-Clause
// Drives a run over all frames and writes its results; run_preparation.cpp has what comes before.
#include "engine/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/provenance.hpp"
#include "engine/results.hpp"
#include "engine/saved_state.hpp"
#include "host/guard.hpp"
#include "record/digest.hpp"

namespace tolman::engine {
namespace {

record::RunState stateOf(const Outcome& outcome) {
  if (outcome.failure) return record::RunState::Failed;
  return outcome.interrupted ? record::RunState::Interrupted : record::RunState::Finished;
}

std::optional<Failure> recordFailure(const Status& status) {
  if (status.isOk()) return std::nullopt;
  return Failure(kindOf(status, FailureKind::Record), status.message());
}

}  // namespace

Outcome Run::execute(CheckedSystem system) {
  Outcome outcome;
  try {
    prepare(std::move(system));
    drive(outcome);
  } catch (const Failure& failure) {
    outcome.interrupted = failure.kind == FailureKind::Interrupted;
    if (!outcome.interrupted) outcome.failure = failure;
    if (outcome.interrupted) log_.write(LogLevel::Warning, failure.stage, failure.message);
  }
  conclude(outcome);
  return outcome;
}

void Run::drive(Outcome& outcome) {
  const std::int64_t begin_ns = clock_.steadyNs();
  RunListener listener(*recorder_, *assembly_, *directory_, log_, clock_);
  Chain chain(assembly_->stages(), assembly_->policies(), listener);
  if (earlier_scale_) chain.continueMap(*earlier_scale_);
  if (resume_) {
    chain.resume(*resume_);
    listener.startAfter(resume_->checkpoint.frame);
  }
  Status begun = listener.begin(
      {config().general.name, directory_->path().string(), assembly_->sourceInfo(), arrays_});
  if (begun.isOk() && resume_) begun = listener.showRecorded();
  if (!begun.isOk()) chain.fail(Role::Observer, begun);
  Watchdog watchdog(chain.stageActivity(), clock_, watchdogSettings(listener));
  watchdog.start();
  const DriveResult result =
      engine::drive(chain, config().pipeline, config().general.threads, stop_);
  const std::optional<Failure> unsaved = saveState(result, listener);
  for (const Status& status : assembly_->teardown()) {
    listener.onEvent({-1, LogLevel::Warning, "teardown", status.message()});
  }
  warnOfSource(result, listener);
  listener.reportRepeated();
  // The first that is one is the failure of the run.
  const std::optional<Failure> failures[] = {
      recordFailure(listener.recordStatus()), recordFailure(recorder_->close()), failureOf(result),
      unsaved, result.interrupted ? stop_.reason() : std::nullopt};
  for (const auto& failure : failures) {
    if (!outcome.failure) outcome.failure = failure;
  }
  outcome.interrupted = result.interrupted;
  outcome.counters = result.counters;
  outcome.finish_times_ns = result.finish_times_ns;
  outcome.latency = result.latency;
  outcome.wall_s = 1e-9 * static_cast<double>(clock_.steadyNs() - begin_ns);
}

/// Times in another unit give wrong velocities. A source may know beforehand how many frames it
/// has; fewer may mean damaged data.
void Run::warnOfSource(const DriveResult& result, RunListener& listener) {
  constexpr double kImpossible_s = 10;  // no odometry follows such images
  if (result.failure || result.interrupted) return;
  const auto warn = [&](const std::string& text) {
    listener.onEvent({-1, LogLevel::Warning, "source", text});
  };
  if (const double step = listener.meanStep(); step > kImpossible_s) {
    warn(fmt::format(
        "frames are {:.4g} s apart (mean); stamps are in ns: are they in another unit?", step));
  }
  const std::int64_t known = assembly_->sourceInfo().frames;
  const std::int64_t given = result.counters.frames + result.counters.dropped;
  if (known < 0 || given == known) return;
  warn(fmt::format("gave {} frames, and had announced {}", given, known));
}

WatchdogSettings Run::watchdogSettings(RunListener& listener) {
  WatchdogSettings settings;
  settings.deadline_s = config().pipeline.stage_deadline;
  settings.disk_left = [&] { return diskLeft(directory_->path()); };
  settings.disk_needed = [&] { return diskNeeded(directory_->path()); };
  settings.report = [&](LogLevel level, std::string_view source, const std::string& text) {
    listener.onEvent({-1, level, std::string(source), text});
  };
  settings.stop = [&](const std::string& why) {
    stop_.stop({FailureKind::Record, directory_->path().string() + ": " + why});
  };
  return settings;
}

std::optional<Failure> Run::failureOf(const DriveResult& result) {
  const RunCounters& n = result.counters;
  if (result.failure || result.interrupted || n.frames > 0) return result.failure;
  const Failure failure =
      n.skipped > 0
          ? Failure(FailureKind::Stage, "every frame was skipped, as a stage failed at each")
          : Failure(FailureKind::Dataset,
                    "source: gave no frame; look at first, last and step, and at the data");
  log_.write(LogLevel::Error, "source", failure.message, false);
  return failure;
}

/// Saves the state for a later run that continues this one. After a failure no state is saved.
/// Stages without StateKeeper are left out; if another one cannot save its state, the run cannot be
/// continued: a stage that was left out of its rest (`on_failure: skip`) has no state.
std::optional<Failure> Run::saveState(const DriveResult& result, RunListener& listener) {
  const RunCounters& n = result.counters;
  const bool is_sound = !result.failure && listener.recordStatus().isOk();
  if (!is_sound || n.frames == 0 || !directory_->stillInPlace().isOk()) return std::nullopt;
  Status stage_failure;
  const Status written = engine::saveState(*assembly_, directory_->path(),
                                           {listener.nextFrame() - 1, n, {}}, stage_failure);
  if (!written.isOk()) return recordFailure(written);
  if (stage_failure.isOk()) return std::nullopt;
  if (n.skipped == 0) {
    return Failure(kindOf(stage_failure, FailureKind::Stage), stage_failure.message());
  }
  listener.onEvent(
      {-1, LogLevel::Warning, "state", stage_failure.message() + "; this run cannot be continued"});
  return std::nullopt;
}

/// Writes what the run leaves, also after a failure. run.json is its last file: until it is
/// written, and whatever ends the process before, it says that the run is running.
void Run::conclude(Outcome& outcome) {
  if (!directory_) return;  // nothing was changed
  outcome.directory = directory_->path();
  if (run_file_.is_null()) return;
  const Status in_place = directory_->stillInPlace();
  failUnlessWritten(outcome, in_place);
  if (in_place.isOk() && outcome.counters.frames > 0) writeResultFiles(outcome);
  completeRunFile(outcome);
  const Status written = directory_->writeRunFile(run_file_, stateOf(outcome));
  failUnlessWritten(outcome, written);
  std::error_code ignored;
  if (!written.isOk()) {  // the report says how the run ended, and run.json does not
    std::filesystem::remove(directory_->path() / "report.html", ignored);
  }
  if (stateOf(outcome) == record::RunState::Finished) removeCheckpoint(directory_->path());
}

void Run::writeResultFiles(Outcome& outcome) {
  auto results = writeResults(directory_->path(), config().evaluation,
                              static_cast<std::uint64_t>(config().general.seed));
  failUnlessWritten(outcome, results.status());
  const auto digest = record::recordDigest(directory_->path());
  failUnlessWritten(outcome, digest.status());
  if (digest.isOk() && !digest.value().empty()) {
    run_file_[record::kRecordDigest] = digest.value();
  }
  failUnlessWritten(outcome, log_.status());
  if (!results.isOk()) return;
  // Counts include earlier sessions, as in metrics.json.
  outcome.metrics = results.value().data.metrics;
  const evaluation::MapCounts& counts = outcome.metrics->counts;
  outcome.counters.links = counts.links;
  outcome.counters.loop_links = counts.loop_links;
  outcome.counters.loop_decisions = counts.loop_decisions;
  if (!config().record.report) return;
  completeRunFile(outcome);
  failUnlessWritten(outcome, host::contained([&] {
                      return writeReport(
                          *results.value().reader, std::move(results.value().data),
                          record::RunDirectory::runFileText(run_file_, stateOf(outcome)));
                    }));
}

void Run::completeRunFile(const Outcome& outcome) {
  addOutcome(run_file_, outcome);
  if (options_.exit_code) run_file_["exit_code"] = options_.exit_code(outcome);
}

/// Makes the run fail if a file cannot be written completely. The outcome keeps the first failure,
/// which the caller shows.
void Run::failUnlessWritten(Outcome& outcome, const Status& written) {
  if (written.isOk()) return;
  log_.write(LogLevel::Error, "record", written.message(), outcome.failure.has_value());
  if (!outcome.failure) outcome.failure = recordFailure(written);
}

}  // namespace tolman::engine
