// SPDX-License-Identifier: BSD-3-Clause
// Drives a run over all frames and writes its results; run_preparation.cpp has what comes before.
#include "engine/run.hpp"

#include <fmt/format.h>

#include <utility>

#include "engine/provenance.hpp"
#include "engine/report_files.hpp"
#include "engine/results.hpp"
#include "engine/saved_state.hpp"
#include "host/guard.hpp"
#include "record/run_check.hpp"

namespace tolman::run {
namespace {

record::RunState stateOf(const Outcome& outcome) {
  if (outcome.failure) return record::RunState::Failed;
  return outcome.interrupted ? record::RunState::Interrupted : record::RunState::Finished;
}

Failure recordFailure(const Status& status) {
  return {kindOf(status, FailureKind::Record), status.message()};
}

}  // namespace

Outcome Run::execute(CheckedSystem system) {
  Outcome outcome;
  try {
    prepare(std::move(system));
  } catch (const Failed& failed) {
    outcome.failure = failed.failure;
  }
  if (outcome.failure && outcome.failure->kind == FailureKind::Interrupted) {
    log_.write(LogLevel::Warning, outcome.failure->stage, outcome.failure->message);
    outcome.failure.reset();
    outcome.interrupted = true;
    return outcome;
  }
  if (directory_) outcome.directory = directory_->path();
  if (resume_ && !directory_) {  // resuming failed or was cancelled: nothing was changed
    outcome.interrupted = !outcome.failure;
    return outcome;
  }
  if (outcome.failure) {
    if (!run_file_.is_null()) writeRunFile(outcome);  // it may still have the status "running"
    return outcome;
  }
  drive(outcome);
  failIfInputsChanged(outcome);
  failIfNothingCame(outcome);
  if (const Status moved = directory_->stillInPlace(); !moved.isOk()) {
    outcome.failure = recordFailure(moved);
    writeRunFile(outcome);
    return outcome;
  }
  conclude(outcome);
  if (stateOf(outcome) == record::RunState::Finished) removeCheckpoint(directory_->path());
  return outcome;
}

void Run::drive(Outcome& outcome) {
  const std::int64_t begin_ns = clock_.steadyNs();
  RunListener listener(*recorder_, *assembly_, *directory_, log_, clock_);
  pipeline::Chain chain(assembly_->stages(), assembly_->policies(), listener);
  if (answers_) listener.recordAnswers(*answers_);
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
  const pipeline::DriveResult result =
      pipeline::drive(chain, config().pipeline, config().general.threads, stop_);
  const std::optional<Failure> unsaved = saveState(result, listener);
  for (const Status& status : assembly_->teardown()) {
    listener.onEvent({-1, LogLevel::Warning, "teardown", status.message()});
  }
  listener.takeFindings(true);
  warnOfSource(result, listener);
  outcome.failure = failureOf(result.failure, listener);
  if (!outcome.failure) outcome.failure = unsaved;
  if (!outcome.failure && result.interrupted) outcome.failure = stop_.reason();
  const Status closed = recorder_->close();
  if (!closed.isOk() && listener.recordStatus().isOk()) outcome.failure = recordFailure(closed);
  outcome.interrupted = result.interrupted;
  outcome.counters = result.counters;
  outcome.finish_times_ns = result.finish_times_ns;
  outcome.latency = result.latency;
  outcome.wall_s = 1e-9 * static_cast<double>(clock_.steadyNs() - begin_ns);
}

/// A source may know beforehand how many frames it has; fewer may mean damaged data, and more that
/// what it tells of them is wrong. Likewise what SourceNotes has seen.
void Run::warnOfSource(const pipeline::DriveResult& result, RunListener& listener) {
  const std::string source = assembly_->stageName(Role::Source);
  if (!result.failure && !resume_) {  // a resumed run sees only the rest of the frames
    for (const std::string& note :
         listener.sourceNotes().atEnd(assembly_->sourceInfo().has_truth)) {
      listener.onEvent({-1, LogLevel::Warning, source, note});
    }
  }
  const std::int64_t known = assembly_->sourceInfo().frames;
  const std::int64_t given = result.counters.frames + result.counters.dropped;
  if (result.failure || result.interrupted || known < 0 || given == known) return;
  const std::string text =
      given < known ? fmt::format("ended after {} of the {} frames that it had told", given, known)
                    : fmt::format("gave {} frames, and had told {}", given, known);
  listener.onEvent({-1, LogLevel::Warning, source, text});
}

WatchdogSettings Run::watchdogSettings(RunListener& listener) {
  WatchdogSettings settings = WatchdogSettings::of(directory_->path());
  settings.deadline_s = config().pipeline.stage_deadline;
  settings.report = [&](LogLevel level, std::string_view source, const std::string& text) {
    listener.onEvent({-1, level, std::string(source), text});
  };
  settings.stop = [&](const std::string& why) {
    stop_.stop({FailureKind::Record, directory_->path().string() + ": " + why});
  };
  return settings;
}

std::optional<Failure> Run::failureOf(const std::optional<pipeline::StageFailure>& stage,
                                      const RunListener& listener) const {
  if (!listener.recordStatus().isOk()) return recordFailure(listener.recordStatus());
  if (!stage) return std::nullopt;
  Failure failure = assembly_->failureOf(*stage);
  if (stage->role == Role::Observer) failure.stage = listener.failedObserver();
  return failure;
}

/// Saves the state for a later run that continues this one. After a failure no state is saved.
/// Stages without StateKeeper are left out; if another one cannot save its state, the run fails.
std::optional<Failure> Run::saveState(const pipeline::DriveResult& result, RunListener& listener) {
  const pipeline::RunCounters& n = result.counters;
  if (result.failure || n.frames == 0 || !listener.recordStatus().isOk() ||
      !directory_->stillInPlace().isOk()) {
    return std::nullopt;
  }
  std::optional<Failure> unsaved =
      run::saveState(*assembly_, directory_->path(), {listener.nextFrame(), n.experiences, -1});
  // A stage that was left out of the rest of the run (`on_failure: skip`) has no state.
  if (!unsaved || n.skipped == 0 || unsaved->kind != FailureKind::Stage) return unsaved;
  listener.onEvent(
      {-1, LogLevel::Warning, "state", unsaved->message + "; this run cannot be continued"});
  return std::nullopt;
}

/// A run whose data changed while it read them has results of two data sets.
void Run::failIfInputsChanged(Outcome& outcome) {
  if (outcome.failure || outcome.interrupted) return;
  const std::filesystem::path changed = record::firstChanged(inputs_);
  if (changed.empty()) return;
  outcome.failure = Failure{FailureKind::Dataset,
                            changed.string() +
                                ": was changed or removed while the run was going, so the results "
                                "may be of two data sets; run it again"};
  log_.write(LogLevel::Error, "source", outcome.failure->message, false);
}

void Run::failIfNothingCame(Outcome& outcome) {
  const pipeline::RunCounters& n = outcome.counters;
  if (outcome.failure || outcome.interrupted || n.frames > 0) return;
  outcome.failure =
      n.skipped > 0
          ? Failure{FailureKind::Stage, "every frame was skipped, as a stage failed at each"}
          : Failure{FailureKind::Dataset,
                    "source: gave no frame; look at first, last and step, and at the data"};
  log_.write(LogLevel::Error, "source", outcome.failure->message, false);
}

void Run::conclude(Outcome& outcome) {
  Result<Results> results = Status::failed("no frame was processed");
  if (outcome.counters.frames > 0) {
    results = writeResults(directory_->path(), config().evaluation,
                           static_cast<std::uint64_t>(config().general.seed));
    failUnlessWritten(outcome, results.status());
  }
  if (results.isOk()) {  // counts include earlier sessions, as in metrics.json
    outcome.metrics = results.value().data.metrics;
    const evaluation::MapCounts& counts = outcome.metrics->counts;
    outcome.counters.links = counts.links;
    outcome.counters.loop_links = counts.loop_links;
    outcome.counters.loop_decisions = counts.loop_decisions;
  }
  failUnlessWritten(outcome, record::checkConfig(directory_->path(), run_file_));
  failUnlessWritten(outcome, log_.status());
  if (!std::filesystem::exists(directory_->path() / "log.txt")) {
    failUnlessWritten(outcome, Status::failed((directory_->path() / "log.txt").string() +
                                              ": was removed while the run was going"));
  }
  if (results.isOk() && config().record.report) {
    completeRunFile(outcome);
    failUnlessWritten(outcome, host::contained([&] {
                        return writeReport(
                            *results.value().reader, std::move(results.value().data),
                            record::RunDirectory::runFileText(run_file_, stateOf(outcome)));
                      }));
  }
  if (writeRunFile(outcome)) return;
  std::error_code ignored;  // the report tells of an end that run.json does not have
  std::filesystem::remove(directory_->path() / "report.html", ignored);
}

void Run::completeRunFile(const Outcome& outcome) {
  addOutcome(run_file_, outcome);
  if (options_.exit_code) run_file_["exit_code"] = options_.exit_code(outcome);
}

/// The last file of a run: until it is written, and whatever ends the process before, run.json says
/// that the run is running.
bool Run::writeRunFile(Outcome& outcome) {
  completeRunFile(outcome);
  const Status written = directory_->writeRunFile(run_file_, stateOf(outcome));
  failUnlessWritten(outcome, written);
  return written.isOk();
}

/// Makes the run fail if a result file cannot be written completely. The outcome keeps the first
/// failure, which the caller shows.
void Run::failUnlessWritten(Outcome& outcome, const Status& written) {
  if (written.isOk()) return;
  log_.write(LogLevel::Error, "record", written.message(), outcome.failure.has_value());
  if (!outcome.failure) outcome.failure = recordFailure(written);
}

}  // namespace tolman::run
