// SPDX-License-Identifier: BSD-3-Clause
#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "config/paths.hpp"
#include "config/resolved.hpp"
#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/run_id.hpp"
#include "run/input_data.hpp"
#include "run/provenance.hpp"
#include "run/report_files.hpp"
#include "run/results.hpp"
#include "run/resume.hpp"
#include "run/saved_state.hpp"

namespace tolman::run {
namespace {

record::RunState stateOf(const Outcome& outcome) {
  if (outcome.failure) return record::RunState::Failed;
  return outcome.interrupted ? record::RunState::Interrupted : record::RunState::Finished;
}

Failure recordFailure(const Status& status) { return {FailureKind::Record, status.message()}; }

constexpr const char* kResolvedConfig = "config.resolved.yaml";
constexpr const char* kConfigDigest = "config_sha256";

/// Refuses to resume a run whose config.resolved.yaml was changed since it was written.
void refuseOtherConfig(const std::filesystem::path& run, const nlohmann::ordered_json& run_file) {
  const auto recorded = run_file.find(kConfigDigest);
  const auto digest = record::fileDigest(run / kResolvedConfig);
  if (recorded == run_file.end() || (digest.isOk() && *recorded == digest.value())) return;
  refuseToContinue((run / kResolvedConfig).string() +
                   ": has changed since the run was recorded; put it back, or run it again");
}

/// Refuses to resume a run whose data have changed: its results would be of two data sets.
void refuseOtherData(const std::filesystem::path& run, const nlohmann::ordered_json& before,
                     const nlohmann::ordered_json& now) {
  if (!before.contains("data")) return;
  const nlohmann::json recorded = before["data"];  // not ordered: equal in any order of keys
  const nlohmann::json found = now["data"];
  if (recorded == found) return;
  std::string path = "the list of files";
  for (const auto& data : found) {
    if (std::ranges::find(recorded, data) != recorded.end()) continue;
    path = data["path"].get<std::string>();
    break;
  }
  refuseToContinue(path + ": has other contents than when the run began (" +
                   (run / "run.json").string() + "); put them back, or run it again");
}

/// Refuses a run directory that contains input data: replacing an earlier run there could delete
/// them.
void refuseInputsIn(const std::filesystem::path& out, const std::vector<record::DataFile>& inputs) {
  std::error_code ignored;
  if (out.empty() || !std::filesystem::exists(out, ignored)) return;
  for (const record::DataFile& input : inputs) {
    if (!record::isInside(input.path, out)) continue;
    throw Failed({FailureKind::Record, out.string() + ": holds data that the run reads (" +
                                           input.path.string() + "); choose another --out"});
  }
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

void Run::prepare(CheckedSystem system) {
  inputs_ = inputFiles(inputPaths(system));
  checkOut(system.config.general.continue_from);
  assembly_ = std::make_unique<Assembly>(std::move(system), log_, clock_, stop_);
  require(assembly_->describeArrays(arrays_), FailureKind::Plugin);
  const std::string doubt = assembly_->source().doubt();
  if (!doubt.empty()) log_.write(LogLevel::Warning, "source", doubt);
  if (!options_.resume.empty()) {
    resumeRun();
    return;
  }
  continueEarlierRun();
  openDirectory();
  openRecord();
}

/// Refuses a directory that cannot be taken before the plugins are configured, which may last;
/// openDirectory() does it again. The refusal to continue in the own directory comes first.
void Run::checkOut(const std::string& continued) const {
  std::error_code ignored;
  if (options_.out.empty() || !options_.resume.empty()) return;
  if (!continued.empty() && std::filesystem::equivalent(options_.out, continued, ignored)) return;
  refuseInputsIn(options_.out, inputs_);
  require(record::RunDirectory::mayTake(options_.out, options_.replace), FailureKind::Record);
}

/// Loads the map of the earlier run that `continue` names, if any.
void Run::continueEarlierRun() {
  const std::string& directory = config().general.continue_from;
  if (directory.empty()) return;
  std::error_code ignored;
  if (!options_.out.empty() && std::filesystem::equivalent(options_.out, directory, ignored)) {
    refuseToContinue(directory +
                     ": a run cannot continue in its own directory; give another one with --out");
  }
  if (record::RunDirectory::isBeingWritten(directory)) {
    refuseToContinue(directory + ": this run is still going; wait for its end, or interrupt it");
  }
  earlier_ = require(record::RunReader::open(directory), FailureKind::Continuation);
  if (const Status status = record::RunDirectory::checkRunFile(directory); !status.isOk()) {
    refuseToContinue(status.message() + "; put it back, or run the earlier session again");
  }
  require(record::Recorder::inheritable(*earlier_), FailureKind::Continuation);
  const std::int64_t frames = require(earlier_->nextFrame(), FailureKind::Continuation);
  const SessionProgress before = loadState(*assembly_, directory);
  if (frames < before.frames || (before.finished && frames > before.frames)) {
    refuseToContinue(
        fmt::format("{}: run.sqlite has {} frames, the saved map {}; they are not of one run",
                    directory, frames, before.frames));
  }
  first_frame_ = before.frames;
  assembly_->source().startAt(first_frame_);
  assembly_->odometry().startAt(first_frame_);
  assembly_->place().resetChecks(before.templates);
  assembly_->cells().resetChecks(before.experiences,
                                 before.templates < 0 ? host::kUnlimited : before.templates);
}

/// Brings the stages to the state of the last checkpoint of the run that `resume` names. If that
/// fails, its directory is unchanged.
void Run::resumeRun() {
  const std::filesystem::path& path = options_.resume;
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
  refuseOtherConfig(path, before);
  nlohmann::ordered_json now = provenance(*assembly_, options_.command_line);
  refuseOtherData(path, before, now);
  record::RunDirectory directory =
      require(record::RunDirectory::reopen(path), FailureKind::Continuation);
  log_.write(LogLevel::Info, "resume", "source and odometry repeat the recorded frames");
  resume_ = resumeAt(*assembly_, directory.path(), stop_);
  if (stop_.requested()) return;
  directory_ = std::make_unique<record::RunDirectory>(std::move(directory));
  reopenRecord(std::move(before), std::move(now));
}

void Run::reopenRecord(nlohmann::ordered_json before, nlohmann::ordered_json now) {
  const std::int64_t next_frame = resume_->checkpoint.frame + 1;
  require(directory_->removeDerived(), FailureKind::Record);
  require(log_.openFile(directory_->path() / "log.txt", RunLog::Open::Append), FailureKind::Record);
  assembly_->openArtefacts(directory_->path());
  run_file_ = std::move(now);
  for (const char* kept :
       {record::kRunIdKey, "started", "command_line", kConfigDigest, "continued", "resumed"}) {
    if (before.contains(kept)) run_file_[kept] = std::move(before[kept]);
  }
  if (!run_file_["resumed"].is_array()) run_file_["resumed"] = nlohmann::ordered_json::array();
  run_file_["resumed"].push_back({{"time", utcText(utcSeconds())}, {"first_frame", next_frame}});
  require(directory_->writeRunFile(run_file_, record::RunState::Running), FailureKind::Record);
  recorder_ =
      require(record::Recorder::reopen(directory_->path(), next_frame), FailureKind::Record);
  if (!recorder_->rowsWereCompared()) {
    log_.write(LogLevel::Info, "resume",
               "an earlier version recorded run.sqlite; whether its rows were changed since cannot "
               "be told");
  }
  if (config().record.replay) {
    answers_ = require(record::AnswersFile::reopen(directory_->path(), next_frame, runId()),
                       FailureKind::Continuation);
  }
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
    require(recorder_->inherit(*earlier_, first_frame_), FailureKind::Record);
    warnOfOtherCamera(require(earlier_->records<CameraRig>(), FailureKind::Record));
    earlier_.reset();
  }
  require(recorder_->session(session), FailureKind::Record);
}

/// Views that another camera saw may not be recognised. `before`: the rigs of the earlier session.
void Run::warnOfOtherCamera(const std::vector<CameraRig>& before) {
  const CameraRig& now = assembly_->sourceInfo().rig;
  if (before.empty() || before.front().width == 0 || now.width == 0) return;
  std::string changes;
  visitFields(before.front(), [&](const Field& field, const auto& then) {
    visitFields(now, [&](const Field& other, const auto& value) {
      if constexpr (std::is_same_v<decltype(then), decltype(value)>) {
        if (field.name != other.name || then == value) return;
        changes += fmt::format("{}{} was {} and is {}", changes.empty() ? "" : ", ", field.name,
                               then, value);
      }
    });
  });
  if (changes.empty()) return;
  const std::string text = "the camera is another than in the earlier session (" + changes +
                           "); places seen with the earlier one may not be recognised";
  log_.write(LogLevel::Warning, "continue", text);
  require(recorder_->event(-1, LogLevel::Warning, "continue", text), FailureKind::Record);
}

/// Called after all plugins are configured and the earlier run is read: failures until then leave
/// an existing run directory unchanged.
void Run::openDirectory() {
  refuseInputsIn(options_.out, inputs_);
  record::RunDirectoryOptions options;
  options.name = config().general.name;
  options.utc_seconds = utcSeconds();
  if (!options_.out.empty()) options.out = options_.out;
  options.replace = options_.replace;
  directory_ = std::make_unique<record::RunDirectory>(
      require(record::RunDirectory::create(options), FailureKind::Record));
  require(log_.openFile(directory_->path() / "log.txt"), FailureKind::Record);
  warnOfKeptFiles();
  assembly_->openArtefacts(directory_->path());
}

/// Files of the user in the folders of the replaced run are beside those of the new one.
void Run::warnOfKeptFiles() const {
  const auto& kept = directory_->kept();
  if (kept.empty()) return;
  constexpr std::size_t kMostNamed = 5;
  std::string text = "files that Tolman did not write were kept in the directory of this run: ";
  for (std::size_t i = 0; i < std::min(kept.size(), kMostNamed); ++i) {
    text += (i > 0 ? ", " : "") + kept[i].string();
  }
  if (kept.size() > kMostNamed) text += fmt::format(" and {} more", kept.size() - kMostNamed);
  log_.write(LogLevel::Warning, "record", text);
}

void Run::openRecord() {
  run_file_ = provenance(*assembly_, options_.command_line);
  if (!config().general.continue_from.empty()) {
    run_file_["continued"] = {{"directory", config().general.continue_from},
                              {"first_frame", first_frame_}};
  }
  const std::string yaml = config::resolvedYaml(config(), assembly_->system().values);
  require(record::writeAtomically(directory_->path() / kResolvedConfig, yaml), FailureKind::Record);
  run_file_[kConfigDigest] =
      require(record::fileDigest(directory_->path() / kResolvedConfig), FailureKind::Record);
  const bool is_realtime = config().pipeline.mode == config::PipelineMode::Realtime;
  run_file_[record::kRunIdKey] = newRunId(run_file_, is_realtime);
  require(directory_->writeRunFile(run_file_, record::RunState::Running), FailureKind::Record);
  recorder_ = require(record::Recorder::open(directory_->path(), runId()), FailureKind::Record);
  recordSessions();
  require(recorder_->meta("name", config().general.name), FailureKind::Record);
  const bool has_images = assembly_->sourceInfo().rig.width > 0;
  if (config().record.replay || (options_.share_answers && has_images)) openAnswers();
}

std::string Run::runId() const { return run_file_.value(record::kRunIdKey, ""); }

void Run::openAnswers() {
  std::vector<ArrayInfo> sensors;
  require(assembly_->source().instance().describe(sensors), FailureKind::Plugin);
  answers_ = require(
      record::AnswersFile::create(directory_->path(), assembly_->sourceInfo(), sensors, runId()),
      FailureKind::Record);
}

void Run::drive(Outcome& outcome) {
  const std::int64_t begin_ns = clock_.steadyNs();
  RunListener listener(*recorder_, *assembly_, *directory_, log_, clock_);
  pipeline::Chain chain(assembly_->stages(), assembly_->policies(), listener);
  if (answers_) listener.recordAnswers(*answers_);
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
  failUnlessWritten(outcome, log_.status());
  if (!std::filesystem::exists(directory_->path() / "log.txt")) {
    failUnlessWritten(outcome, Status::failed((directory_->path() / "log.txt").string() +
                                              ": was removed while the run was going"));
  }
  writeRunFile(outcome);
  if (!results.isOk() || !config().record.report) return;
  const Status reported = writeReport(*results.value().reader, std::move(results.value().data));
  if (reported.isOk()) return;
  failUnlessWritten(outcome, reported);
  if (writeRunFile(outcome)) return;
  // run.json has the status "finished", which cannot be replaced, for example on a full disk.
  std::error_code ignored;
  std::filesystem::remove(directory_->path() / "run.json", ignored);
}

bool Run::writeRunFile(Outcome& outcome) {
  addOutcome(run_file_, outcome);
  if (options_.exit_code) run_file_["exit_code"] = options_.exit_code(outcome);
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
