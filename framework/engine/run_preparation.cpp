// SPDX-License-Identifier: BSD-3-Clause
// What a run does before its first frame: it configures the stages, loads the state of an earlier
// run that it continues or resumes, and opens the run directory and the record.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "config/system_config.hpp"
#include "config/values.hpp"
#include "engine/input_data.hpp"
#include "engine/program_changes.hpp"
#include "engine/provenance.hpp"
#include "engine/resume.hpp"
#include "engine/run.hpp"
#include "engine/saved_state.hpp"
#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/run_check.hpp"
#include "record/run_id.hpp"

namespace tolman::run {
namespace {

constexpr const char* kResolvedConfig = "config.resolved.yaml";
using record::kConfigDigest;

/// Refuses to resume a run whose config.resolved.yaml was changed since it was written.
void refuseOtherConfig(const std::filesystem::path& run, const nlohmann::ordered_json& run_file) {
  const Status status = record::checkConfig(run, run_file);
  if (!status.isOk()) refuseToContinue(status.message());
}

[[noreturn]] void refuseChanged(const std::string& path, const std::filesystem::path& run,
                                const std::string& remedy) {
  refuseToContinue(path + ": has other contents than when the run began (" +
                   (run / "run.json").string() + "); " + remedy + ", or run it again");
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
  refuseChanged(path, run, "put them back");
}

/// Refuses to resume a run with another version of this program, or if the files of the plugins of
/// its stages have changed: the saved states are theirs. Observers start again, so they may be
/// others.
void refuseOtherPrograms(const std::filesystem::path& run, const nlohmann::ordered_json& before,
                         const nlohmann::ordered_json& now) {
  constexpr const char* kHost = "tolman";
  if (before.contains(kHost) && nlohmann::json(before[kHost]) != nlohmann::json(now[kHost])) {
    refuseToContinue((run / "run.json").string() + ": the run was begun by another version of " +
                     "tolman (" + before[kHost].dump() + ", this is " + now[kHost].dump() +
                     "); resume it with that one, or run it again");
  }
  const std::vector<std::string> changed = changedProgramFiles(
      before, now, {Role::Source, Role::Odometry, Role::Place, Role::Cells, Role::Map});
  if (!changed.empty()) refuseChanged(changed.front(), run, "put it back");
}

/// Paths of "data" whose digests are known of both runs, and are others.
std::vector<std::string> changedData(const nlohmann::ordered_json& before,
                                     const nlohmann::ordered_json& now) {
  constexpr const char* kDigest = "sha256";
  std::vector<std::string> changed;
  if (!before.is_object() || !before.contains("data")) return changed;
  for (const auto& old : before["data"]) {
    if (!old.is_object() || !old.contains("path") || !old.contains(kDigest)) continue;
    for (const auto& data : now["data"]) {
      if (data["path"] != old["path"] || !data.contains(kDigest)) continue;
      if (data[kDigest] != old[kDigest]) changed.push_back(data["path"]);
    }
  }
  return changed;
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

void Run::prepare(CheckedSystem system) {
  inputs_ = inputFiles(inputPaths(system));
  checkOut(system.config.general.continue_from);
  assembly_ = std::make_unique<Assembly>(std::move(system), log_, clock_, stop_);
  require(assembly_->describeArrays(arrays_), FailureKind::Plugin);
  for (const std::string& doubt : assembly_->source().doubts()) {
    log_.write(LogLevel::Warning, "source", doubt);
  }
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
  if (const auto scale = require(earlier_->lastScale(first_frame_), FailureKind::Continuation)) {
    earlier_scale_ = {scale->is_known, directory};
  }
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
  refuseOtherPrograms(path, before, now);
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
    warnOfOtherPrograms();
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

/// A state was loaded that other contents of a program, or of a file that a parameter names, may
/// have made. Files whose digests are not known are not compared.
void Run::warnOfOtherPrograms() {
  const auto before = record::RunDirectory::readRunFile(config().general.continue_from);
  std::vector<std::string> changed =
      changedProgramFiles(before, run_file_, {Role::Place, Role::Cells, Role::Map});
  const std::vector<std::string> paths = statePaths(assembly_->system());
  for (std::string& path : changedData(before, run_file_)) {
    const bool is_known = std::ranges::find(changed, path) != changed.end();
    if (!is_known && std::ranges::find(paths, path) != paths.end()) changed.push_back(path);
  }
  if (changed.empty()) return;
  const std::string text = fmt::format(
      "{} {} other contents than in the earlier session, whose state was loaded; if that changes "
      "what the state means, begin a new map",
      fmt::join(changed, ", "), changed.size() == 1 ? "has" : "have");
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

}  // namespace tolman::run
