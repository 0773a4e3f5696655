// SPDX-License-Identifier: BSD-3-Clause
// What a run does before its first frame: it configures the stages, loads the state of an earlier
// run that it continues or resumes, and opens the run directory and the record.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "config/system_config.hpp"
#include "config/values.hpp"
#include "engine/checked_system.hpp"
#include "engine/provenance.hpp"
#include "engine/run.hpp"
#include "engine/saved_state.hpp"
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

}  // namespace

void Run::prepare(CheckedSystem system) {
  inputs_ = inputPaths(system).present;
  for (const std::string& note : system.notes) log_.write(LogLevel::Warning, "config", note);
  checkOut(system.config.general.continue_from);
  assembly_ = std::make_unique<Assembly>(std::move(system), log_, clock_, stop_);
  require(assembly_->describeArrays(arrays_), FailureKind::Plugin);
  for (const std::string& doubt : assembly_->source().doubts()) {
    log_.write(LogLevel::Warning, "source", doubt);
  }
  if (!options_.resume.empty()) return resumeRun();
  continueEarlierRun();
  openDirectory();
  openRecord();
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

/// Loads the map of the earlier run that `continue` names, if any.
void Run::continueEarlierRun() {
  const std::string& directory = config().general.continue_from;
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
  for (const char* kept : {record::kRunIdKey, "started", "command_line", record::kConfigDigest,
                           "continued", "resumed"}) {
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
    require(recorder_->inherit(*earlier_, first_frame_), FailureKind::Record);
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
      changedProgramFiles(record::RunDirectory::readRunFile(config().general.continue_from),
                          run_file_, {Role::Place, Role::Cells, Role::Map});
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
  if (!config().general.continue_from.empty()) {
    run_file_["continued"] = {{"directory", config().general.continue_from},
                              {"first_frame", first_frame_}};
  }
  const std::string yaml = config::resolvedYaml(config(), assembly_->system().values);
  require(record::writeAtomically(resolved, yaml), FailureKind::Record);
  run_file_[record::kConfigDigest] = require(record::fileDigest(resolved), FailureKind::Record);
  const bool is_realtime = config().pipeline.mode == config::PipelineMode::Realtime;
  run_file_[record::kRunIdKey] = newRunId(run_file_, is_realtime);
  require(directory_->writeRunFile(run_file_, record::RunState::Running), FailureKind::Record);
  recorder_ =
      require(record::Recorder::open(directory_->path(), run_file_.value(record::kRunIdKey, "")),
              FailureKind::Record);
  recordSessions();
  require(recorder_->meta("name", config().general.name), FailureKind::Record);
  const bool has_images = assembly_->sourceInfo().rig.width > 0;
  if (!config().record.replay && !(options_.share_answers && has_images)) return;
  std::vector<ArrayInfo> sensors;
  require(assembly_->source().instance().describe(sensors), FailureKind::Plugin);
  require(recorder_->recordForReplay(sensors.size()), FailureKind::Record);
}

}  // namespace tolman::engine
