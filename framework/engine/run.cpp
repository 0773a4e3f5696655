// SPDX-License-Identifier: BSD-3-Clause
// What a run does before its first frame: it configures the stages, loads the state of an earlier
// run that it continues or resumes, and opens the run directory and the record. Then it drives the
// stages over all frames and writes its results.
#include "engine/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "config/system_config.hpp"
#include "config/values.hpp"
#include "engine/checked_system.hpp"
#include "engine/provenance.hpp"
#include "engine/results.hpp"
#include "engine/saved_state.hpp"
#include "host/guard.hpp"
#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/run_directory.hpp"

namespace tolman::engine {
namespace {

namespace fs = std::filesystem;
using RunJson = nlohmann::ordered_json;

constexpr const char* kResolvedConfig = "config.resolved.yaml";

/// Refuses to resume a run with another version of this program, with other data, or if the files
/// of the plugins of its stages have changed: its results would be of two of them. Observers start
/// again, so they may be others.
void refuseOthers(const fs::path& run, const RunJson& before, const RunJson& now) {
  const std::string file = (run / "run.json").string();
  const auto others = [&](const char* key) {  // nlohmann::json: equal in any order of keys
    return before.contains(key) && nlohmann::json(before[key]) != nlohmann::json(now[key]);
  };
  if (others("tolman")) {
    refuseToContinue(
        fmt::format("{}: the run was begun by another version of tolman ({}, this is "
                    "{}); resume it with that one, or run it again",
                    file, before["tolman"].dump(), now["tolman"].dump()));
  }
  std::vector<std::string> changed = changedInputs(before, now);
  if (changed.empty() && others("data")) changed.emplace_back("the list of files");
  if (changed.empty()) return;
  refuseToContinue(changed.front() + ": has other contents than when the run began (" + file +
                   "); put it back, or run it again");
}

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

void Run::prepare(CheckedSystem system) {
  inputs_ = inputPaths(system).present;
  const std::vector<std::string> notes = std::move(system.notes);
  checkOut(system.config.general.earlier());
  assembly_ = std::make_unique<Assembly>(std::move(system), log_, clock_, stop_);
  require(assembly_->describeArrays(arrays_), FailureKind::Plugin);
  for (const std::string& doubt : assembly_->source().doubts()) {
    log_.write(LogLevel::Warning, "source", doubt);
  }
  if (!options_.resume.empty()) return resumeRun();
  continueEarlierRun();
  openDirectory();
  openRecord();
  for (const std::string& note : notes) log_.write(LogLevel::Warning, "config", note);
}

/// Refuses a directory that cannot be taken, or contains data of the run (replacing an earlier run
/// there could delete them), before the plugins are configured, which may last. The refusal to
/// continue in the own directory comes first.
void Run::checkOut(const std::string& continued) const {
  std::error_code ignored;
  if (options_.out.empty() || !options_.resume.empty()) return;
  if (!continued.empty() && fs::equivalent(options_.out, continued, ignored)) {
    refuseToContinue(continued +
                     ": a run cannot continue in its own directory; give another one with --out");
  }
  for (const std::string& input : inputs_) {
    if (!fs::exists(options_.out, ignored) || !record::isInside(input, options_.out)) continue;
    throw Failure(FailureKind::Record, options_.out.string() + ": holds data that the run reads (" +
                                           input + "); choose another --out");
  }
  require(record::RunDirectory::mayTake(options_.out, options_.replace), FailureKind::Record);
}

/// Loads the map of the earlier run that `continue` or `localise` names, if any.
void Run::continueEarlierRun() {
  const std::string& directory = config().general.earlier();
  if (directory.empty()) return;
  if (record::RunDirectory::isBeingWritten(directory)) {
    refuseToContinue(directory + ": this run is still going; wait for its end, or interrupt it");
  }
  earlier_ = require(record::RunReader::open(directory), FailureKind::Continuation);
  if (const Status status = record::RunDirectory::checkRunFile(directory); !status.isOk()) {
    refuseToContinue(status.message() + "; put it back, or run the earlier session again");
  }
  const std::int64_t frames = require(earlier_->nextFrame(), FailureKind::Continuation);
  const SavedSession before = loadState(*assembly_, directory);
  if (frames < before.frames || (before.finished && frames > before.frames)) {
    refuseToContinue(
        fmt::format("{}: run.sqlite has {} frames, the saved map {}; they are not of one run",
                    directory, frames, before.frames));
  }
  first_frame_ = before.frames;
  if (const auto scale = require(earlier_->lastScale(first_frame_), FailureKind::Continuation)) {
    earlier_scale_ = {scale->is_known, directory};
  }
  assembly_->source().startAt(first_frame_);
  assembly_->odometry().startAt(first_frame_);
  assembly_->place().resetChecks(-1);
  assembly_->cells().resetChecks(before.experiences);
  if (!localises()) return;
  assembly_->place().localise();
  assembly_->cells().localise();
}

/// Brings the stages to the state of the last checkpoint of the run that `resume` names. If that
/// fails, its directory is unchanged.
void Run::resumeRun() {
  const fs::path& path = options_.resume;
  auto before = record::RunDirectory::readRunFile(path);
  if (!before.is_object()) {
    refuseToContinue((path / "run.json").string() + ": " +
                     config::absence(path / "run.json", "is missing or damaged; run it again"));
  }
  if (before["status"] == enumName(record::RunState::Finished)) {
    refuseToContinue(path.string() +
                     ": this run has finished, there is nothing to resume; to continue its map in "
                     "a new run use --continue");
  }
  require(record::verify(path), FailureKind::Continuation);
  RunJson now = provenance(*assembly_, options_.command_line);
  refuseOthers(path, before, now);
  record::RunDirectory directory =
      require(record::RunDirectory::reopen(path), FailureKind::Continuation);
  log_.write(LogLevel::Info, "resume", "source and odometry repeat the recorded frames");
  resume_ = resumeAt(*assembly_, directory.path(), stop_);
  if (stop_.requested()) {
    throw Failure(FailureKind::Interrupted, "interrupted while it was resumed; nothing was changed",
                  "resume");
  }
  directory_ = std::make_unique<record::RunDirectory>(std::move(directory));
  reopenRecord(std::move(before), std::move(now));
}

void Run::reopenRecord(RunJson before, RunJson now) {
  const std::int64_t next_frame = resume_->checkpoint.frame + 1;
  require(directory_->removeDerived(), FailureKind::Record);
  require(log_.openFile(directory_->path() / "log.txt", RunLog::Open::Append), FailureKind::Record);
  assembly_->openArtefacts(directory_->path());
  run_file_ = std::move(now);
  for (const char* kept :
       {"started", "command_line", record::kConfigDigest, "continued", "resumed"}) {
    if (before.contains(kept)) run_file_[kept] = std::move(before[kept]);
  }
  if (!run_file_["resumed"].is_array()) run_file_["resumed"] = RunJson::array();
  run_file_["resumed"].push_back({{"time", utcText(utcSeconds())}, {"first_frame", next_frame}});
  require(directory_->writeRunFile(run_file_, record::RunState::Running), FailureKind::Record);
  recorder_ =
      require(record::Recorder::reopen(directory_->path(), next_frame), FailureKind::Record);
  MapGraph graph;
  require(assembly_->map().graph(graph), FailureKind::Stage);
  require(recorder_->graph(graph), FailureKind::Record);
}

/// Records the earlier sessions and this one.
void Run::recordSessions() {
  record::RecordedSession session{0, first_frame_, config().general.name,
                                  assembly_->sourceInfo().description};
  if (earlier_) {
    const auto sessions = require(earlier_->sessions(), FailureKind::Record);
    session.id = static_cast<std::int64_t>(sessions.size());
    require(recorder_->inherit(*earlier_, first_frame_, !localises()), FailureKind::Record);
    warnOfOthers(require(earlier_->records<CameraRig>(), FailureKind::Record));
    earlier_.reset();
  }
  require(recorder_->session(session), FailureKind::Record);
}

/// Views that another camera saw may not be recognised, and the state that was loaded may mean
/// something else to other plugins. `before`: the rigs of the earlier session.
void Run::warnOfOthers(const std::vector<CameraRig>& before) {
  const auto warn = [&](const std::string& text) {
    log_.write(LogLevel::Warning, "continue", text);
    require(recorder_->event(-1, LogLevel::Warning, "continue", text), FailureKind::Record);
  };
  const CameraRig& now = assembly_->sourceInfo().rig;
  const auto key = [](const CameraRig& rig) {
    return fmt::format("{}x{} px, fx {:.6g}, fy {:.6g}, cx {:.6g}, cy {:.6g}, baseline {:.6g} m",
                       rig.width, rig.height, rig.pinhole.fx, rig.pinhole.fy, rig.pinhole.cx,
                       rig.pinhole.cy, rig.baseline);
  };
  if (!before.empty() && before.front().width > 0 && now.width > 0 &&
      key(before.front()) != key(now)) {
    warn(fmt::format(
        "the camera is another than in the earlier session (now {}, then {}); places seen "
        "with the earlier one may not be recognised",
        key(now), key(before.front())));
  }
  const std::vector<std::string> changed =
      changedProgramFiles(record::RunDirectory::readRunFile(config().general.earlier()), run_file_,
                          {Role::Place, Role::Cells, Role::Map});
  if (changed.empty()) return;
  warn(
      fmt::format("{} {} other contents than in the earlier session, whose state was loaded; if "
                  "that changes what the state means, begin a new map",
                  fmt::join(changed, ", "), changed.size() == 1 ? "has" : "have"));
}

/// Called after all plugins are configured and the earlier run is read: failures until then leave
/// an existing run directory unchanged.
void Run::openDirectory() {
  record::RunDirectoryOptions options;
  options.name = config().general.name;
  options.utc_seconds = utcSeconds();
  if (!options_.out.empty()) options.out = options_.out;
  options.replace = options_.replace;
  directory_ = std::make_unique<record::RunDirectory>(
      require(record::RunDirectory::create(options), FailureKind::Record));
  require(log_.openFile(directory_->path() / "log.txt"), FailureKind::Record);
  assembly_->openArtefacts(directory_->path());
}

void Run::openRecord() {
  const fs::path resolved = directory_->path() / kResolvedConfig;
  run_file_ = provenance(*assembly_, options_.command_line);
  if (const std::string& earlier = config().general.earlier(); !earlier.empty()) {
    run_file_[localises() ? "localised" : "continued"] = {{"directory", earlier},
                                                          {"first_frame", first_frame_}};
  }
  const std::string yaml = config::resolvedYaml(config(), assembly_->system().values);
  require(record::writeAtomically(resolved, yaml), FailureKind::Record);
  run_file_[record::kConfigDigest] = require(record::fileDigest(resolved), FailureKind::Record);
  require(directory_->writeRunFile(run_file_, record::RunState::Running), FailureKind::Record);
  recorder_ = require(record::Recorder::open(directory_->path()), FailureKind::Record);
  recordSessions();
  require(recorder_->meta("name", config().general.name), FailureKind::Record);
  if (localises()) {
    require(recorder_->meta(record::kLocalisedKey, config().general.localise), FailureKind::Record);
  }
  const bool has_images = assembly_->sourceInfo().rig.width > 0;
  if (!config().record.replay && !(options_.share_answers && has_images)) return;
  std::vector<ArrayInfo> sensors;
  require(assembly_->source().instance().describe(sensors), FailureKind::Plugin);
  require(recorder_->recordForReplay(sensors.size()), FailureKind::Record);
}

void Run::drive(Outcome& outcome) {
  const std::int64_t begin_ns = clock_.steadyNs();
  RunListener listener(*recorder_, *assembly_, *directory_, log_, clock_);
  Chain chain(assembly_->stages(), assembly_->policies(), listener);
  if (earlier_scale_) chain.continueMap(*earlier_scale_);
  if (localises()) {
    MapGraph graph;
    require(assembly_->map().graph(graph), FailureKind::Continuation);
    chain.localise(LocalisedMap(std::move(graph), first_frame_));
  }
  if (resume_) {
    chain.resume(*resume_);
    listener.startAfter(resume_->checkpoint.frame);
  }
  Status begun = listener.begin(
      {config().general.name, directory_->path().string(), assembly_->sourceInfo(), arrays_});
  if (begun.isOk() && resume_) begun = listener.showRecorded();
  if (!begun.isOk()) chain.fail(Role::Observer, begun);
  static_cast<DriveResult&>(outcome) =
      engine::drive(chain, config().pipeline, config().general.threads, stop_);
  const std::optional<Failure> unsaved = saveState(outcome, listener);
  for (const Status& status : assembly_->teardown()) {
    listener.onEvent({-1, LogLevel::Warning, "teardown", status.message()});
  }
  warnOfSource(outcome, listener);
  listener.reportRepeated();
  // The first that is one is the failure of the run.
  const std::optional<Failure> failures[] = {recordFailure(listener.recordStatus()),
                                             recordFailure(recorder_->close()), failureOf(outcome),
                                             unsaved};
  outcome.failure.reset();
  for (const auto& failure : failures) {
    if (!outcome.failure) outcome.failure = failure;
  }
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

/// Saves the state for a later run that continues this one. After a failure no state is saved, nor
/// of a run that changes no map.
/// Stages without StateKeeper are left out; if another one cannot save its state, the run cannot be
/// continued: a stage that was left out of its rest (`on_failure: skip`) has no state.
std::optional<Failure> Run::saveState(const DriveResult& result, RunListener& listener) {
  const RunCounters& n = result.counters;
  const bool is_sound = !result.failure && listener.recordStatus().isOk();
  if (!is_sound || n.frames == 0 || localises() || !directory_->stillInPlace().isOk()) {
    return std::nullopt;
  }
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
    fs::remove(directory_->path() / "report.html", ignored);
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
