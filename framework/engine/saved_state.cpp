// SPDX-License-Identifier: BSD-3-Clause
#include "engine/saved_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

#include "config/json_text.hpp"
#include "engine/provenance.hpp"
#include "record/atomic_file.hpp"

namespace tolman::engine {

namespace {

namespace fs = std::filesystem;
using StateJson = nlohmann::ordered_json;

constexpr const char* kCheckpoint = "checkpoint";

fs::path sessionFile(const fs::path& directory) { return directory / "state" / "session.json"; }

fs::path checkpointFile(const fs::path& directory) {
  return directory / "state" / "checkpoint.json";
}

/// The common prefix of the files of the states of one checkpoint.
std::string prefixOf(std::int64_t frame) { return fmt::format("{}-{}-", kCheckpoint, frame); }
/// The same of the files beside `file`; none where it is that of the end.
std::string prefixOf(const fs::path& file, std::int64_t frame) {
  return file.stem() == kCheckpoint ? prefixOf(frame) : "";
}

[[noreturn]] void refuseDamaged(const fs::path& file) {
  refuseToContinue(file.string() + ": is damaged; run the earlier session again");
}

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open()) {
    refuseToContinue(file.string() + ": cannot be read; the saved session is not complete");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// One of the stages whose state a later run needs.
struct SavedStage {
  host::Instance* instance;
  const config::StageConfig* config;
  StateJson parameters;

  std::string file(const std::string& prefix) const {
    return prefix + std::string(enumName(config->role)) + ".bin";
  }
};

std::vector<SavedStage> savedStages(Assembly& assembly) {
  std::vector<SavedStage> saved;
  const CheckedSystem& system = assembly.system();
  for (std::size_t i = 0; i < system.config.stages.size(); ++i) {
    const config::StageConfig& stage = system.config.stages[i];
    if (stage.role != Role::Place && stage.role != Role::Cells && stage.role != Role::Map) continue;
    StateJson parameters = StateJson::object();
    for (const auto& [name, value] : system.values.find(stage.instance)->second) {
      parameters[name] = valueJson(value);
    }
    saved.push_back({assembly.instances()[i], &stage, std::move(parameters)});
  }
  return saved;
}

/// Writes the state of each stage, and then `file` with plugin, version and parameters of each.
Status write(Assembly& assembly, const fs::path& file, const Checkpoint& state) {
  const fs::path folder = file.parent_path();
  std::error_code ignored;  // writing the files fails
  // Does not create parents, because the run directory may have been moved.
  fs::create_directory(folder, ignored);
  StateJson contents = {{"frame", state.frame},
                        {"counters", countersJson(state.counters)},
                        {"stages", StateJson::array()}};
  for (const SavedStage& stage : savedStages(assembly)) {
    const auto bytes = state.states.find(stage.config->role);
    if (bytes == state.states.end()) continue;
    const fs::path own = folder / stage.file(prefixOf(file, state.frame));
    const Status status = record::writeAtomically(own, bytes->second);
    if (!status.isOk()) return status;
    contents["stages"].push_back({{"role", enumName(stage.config->role)},
                                  {"plugin", stage.instance->manifest().id},
                                  {"version", stage.instance->manifest().version},
                                  {"parameters", stage.parameters}});
  }
  return record::writeAtomically(file, config::jsonText(contents, 2) + "\n");
}

/// Throws Failure for another plugin, version or parameter than in the earlier session.
void checkStage(const StateJson& then, const SavedStage& stage, const fs::path& directory) {
  const std::string& name = stage.config->path;
  const host::Manifest& manifest = stage.instance->manifest();
  const auto refuse = [&](const std::string& what, const std::string& now, const std::string& was) {
    refuseToContinue(fmt::format(
        "{} is {}, and was {} in the earlier session; configure it as in {}, or start a new map",
        what, now, was, (directory / "config.resolved.yaml").string()));
  };
  const auto plugin = then.at("plugin").get<std::string>();
  if (plugin != manifest.id) refuse(name + ".plugin", manifest.id, plugin);
  const auto version = then.at("version").get<std::string>();
  if (version != manifest.version) {
    refuse("the version of " + name + " (" + plugin + ")", manifest.version, version);
  }
  for (const auto& [key, value] : stage.parameters.items()) {
    const auto old = then.at("parameters").find(key);
    const bool is_known = old != then.at("parameters").end();
    if (is_known && *old == value) continue;
    refuse(name + "." + key, value.dump(), is_known ? old->dump() : "unknown");
  }
}

/// Loads the states of place, cells and map into a new assembly.
void loadStates(Assembly& assembly, const fs::path& file, const std::string& prefix,
                const StateJson& contents) {
  const fs::path folder = file.parent_path();
  for (const SavedStage& stage : savedStages(assembly)) {
    const std::string role(enumName(stage.config->role));
    const auto& stages = contents.at("stages");
    const auto entry = std::find_if(stages.begin(), stages.end(),
                                    [&](const StateJson& json) { return json.at("role") == role; });
    if (entry == stages.end()) {
      refuseToContinue(folder.parent_path().string() + ": its " + role +
                       " saved no state; its plugin cannot. Choose one that can, such as those of "
                       "configs/motion.yaml");
    }
    checkStage(*entry, stage, folder.parent_path());
    const fs::path state = folder / stage.file(prefix);
    const Status status = stage.instance->load(textOf(state));
    if (!status.isOk()) refuseToContinue(state.string() + ": " + status.message());
  }
}

std::int64_t experiencesOf(Assembly& assembly) {
  MapGraph graph;
  require(assembly.map().graph(graph), FailureKind::Continuation);
  return static_cast<std::int64_t>(graph.experiences.size());
}

/// The state that `file` describes: at the end of a run, or of a checkpoint.
Checkpoint load(Assembly& assembly, const fs::path& file) {
  try {
    const auto contents = StateJson::parse(textOf(file), nullptr, false);
    Checkpoint state;
    contents.at("frame").get_to(state.frame);
    if (state.frame < 0) refuseDamaged(file);
    RunCounters::visit(state.counters, [&](const char* name, auto& value) {
      contents.at("counters").at(name).get_to(value);
    });
    loadStates(assembly, file, prefixOf(file, state.frame), contents);
    return state;
  } catch (const StateJson::exception&) {  // JSON of a wrong shape
    refuseDamaged(file);
  }
}

/// Removes the files of all checkpoints except that of `frame`; -1: of all.
void removeCheckpointsBut(const fs::path& folder, std::int64_t frame) {
  std::error_code ignored;  // remaining files are removed the next time
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(std::string(kCheckpoint) + "-") && !name.starts_with(prefixOf(frame))) {
      fs::remove(entry.path(), ignored);
    }
  }
}

}  // namespace

Status saveState(Assembly& assembly, const fs::path& directory, Checkpoint state,
                 Status& stage_failure) {
  for (const SavedStage& stage : savedStages(assembly)) {
    if (stage.instance->state() == nullptr) continue;
    Result<std::string> bytes = stage.instance->save();
    if (!bytes.isOk()) {
      stage_failure = bytes.status();
      return Status::ok();
    }
    state.states[stage.config->role] = std::move(bytes).value();
  }
  return state.states.empty() ? Status::ok() : write(assembly, sessionFile(directory), state);
}

SavedSession loadState(Assembly& assembly, const fs::path& directory) {
  const fs::path file = sessionFile(directory);
  std::error_code ignored;
  const bool finished = fs::exists(file, ignored);
  if (!finished && !fs::exists(checkpointFile(directory), ignored)) {
    refuseToContinue(directory.string() +
                     ": this run saved no map that could be continued (it failed, used the map of "
                     "another run, was "
                     "killed before its first checkpoint, is of an older version, or its plugins "
                     "cannot save their state; see its "
                     "log.txt); run it again to its end or to an interrupt");
  }
  const Checkpoint state = load(assembly, finished ? file : checkpointFile(directory));
  const std::int64_t loaded = experiencesOf(assembly);
  if (finished && state.counters.experiences != loaded) {
    refuseToContinue(fmt::format(
        "{}: has {} experiences, the map that was loaded {}; the file is damaged, or the map's "
        "plugin does not load what it saved; run the earlier session again",
        file.string(), state.counters.experiences, loaded));
  }
  return {state.frame + 1, loaded, finished};
}

Status saveCheckpoint(Assembly& assembly, const fs::path& directory, const Checkpoint& checkpoint) {
  const fs::path file = checkpointFile(directory);
  const Status status = write(assembly, file, checkpoint);
  if (status.isOk()) removeCheckpointsBut(file.parent_path(), checkpoint.frame);
  return status;
}

void removeCheckpoint(const fs::path& directory) {
  std::error_code ignored;  // a remaining checkpoint does no harm
  if (!fs::exists(sessionFile(directory), ignored)) return;
  fs::remove(checkpointFile(directory), ignored);
  removeCheckpointsBut(sessionFile(directory).parent_path(), -1);
}

namespace {

/// The record holds a rotation as a quaternion, so the last bits may differ; m and rad.
constexpr double kRounding = 1e-9;

/// The record of frame `frame`, the last one of a checkpoint. Throws Failure if there is none.
template <Record R>
R recordOf(const std::vector<R>& records, std::int64_t frame, const fs::path& directory) {
  const auto found = std::ranges::find(records, frame, &R::frame);
  if (found != records.end()) return *found;
  refuseToContinue(fmt::format(
      "{}: its checkpoint is of frame {}, which run.sqlite does not have (was the power lost?); "
      "run it again",
      directory.string(), frame));
}

/// Whether stamp, source index and truth are the same.
bool isSameFrame(const Frame& a, const Frame& b) {
  return a.stamp_ns == b.stamp_ns && a.source_index == b.source_index &&
         a.has_truth == b.has_truth &&
         (!a.has_truth || a.T_world_camera_truth.isApprox(b.T_world_camera_truth, kRounding));
}

/// Tracks the recorded frames again, without those that a realtime run dropped. Returns the motion
/// of the last one.
Motion repeatOdometry(Assembly& assembly, const std::vector<Motion>& motions,
                      const std::vector<Frame>& frames, std::int64_t last_frame,
                      const Cancellation& cancellation) {
  constexpr const char* kRemedy = "resume with the data of the recorded run, or run it again";
  Motion last;
  std::size_t next = 0;
  for (Frame frame; frame.frame < last_frame && !cancellation.requested();) {
    const Status read = assembly.source().next(frame);
    if (read.code() == StatusCode::EndOfStream) {
      refuseToContinue(fmt::format("source: has fewer frames than were recorded ({}); {}",
                                   last_frame + 1, kRemedy));
    }
    require(read, FailureKind::Dataset, "source");
    while (next + 1 < motions.size() && motions[next].frame < frame.frame) ++next;
    const Motion& before = motions[next];
    if (before.frame != frame.frame) continue;
    const auto recorded = std::ranges::lower_bound(frames, frame.frame, {}, &Frame::frame);
    if (recorded == frames.end() || recorded->frame != frame.frame ||
        !isSameFrame(frame, *recorded)) {
      refuseToContinue(
          fmt::format("source: stamp or true pose of frame {} is another than was recorded; {}",
                      frame.frame, kRemedy));
    }
    (void)assembly.checkedOdometry().admit(frame);  // its note is in the record
    last = Motion();
    std::vector<std::string> in_record;
    if (!assembly.checkedOdometry().track(frame, last, in_record).isOk()) {
      last = before;  // the predicted motion
    }
    if (last.T_previous_current.isApprox(before.T_previous_current, kRounding)) continue;
    refuseToContinue(fmt::format(
        "odometry: gives another motion at frame {} than was recorded; data, plugin or parameters "
        "have changed. Resume with those of the recorded run, or run it again",
        frame.frame));
  }
  return last;
}

}  // namespace

ResumePoint resumeAt(Assembly& assembly, const fs::path& directory,
                     const Cancellation& cancellation) {
  constexpr FailureKind kKind = FailureKind::Continuation;
  const auto reader = require(record::RunReader::open(directory), kKind);
  const auto sessions = require(reader->sessions(), kKind);
  if (sessions.empty())
    refuseToContinue(directory.string() + ": was ended before its first frame; run it again");
  const std::int64_t first_frame = sessions.back().first_frame;
  assembly.source().startAt(first_frame);
  assembly.odometry().startAt(first_frame);

  ResumePoint point;
  std::error_code ignored;
  if (!fs::exists(checkpointFile(directory), ignored)) {
    refuseToContinue(directory.string() +
                     ": has no checkpoint (it ended before the first one, see record.state_every, "
                     "or place, cells or map cannot save their state); run it again");
  }
  point.checkpoint = load(assembly, checkpointFile(directory));
  const std::int64_t last = point.checkpoint.frame;
  const auto motions = require(reader->records<Motion>(), kKind);
  (void)recordOf(motions, last, directory);  // throws if frames to be repeated are missing
  point.decision = recordOf(require(reader->records<Decision>(), kKind), last, directory);
  point.map = recordOf(require(reader->records<MapUpdate>(), kKind), last, directory);
  assembly.place().resetChecks(-1);
  assembly.cells().resetChecks(experiencesOf(assembly));
  const auto frames = require(reader->records<Frame>(), kKind);
  if (const auto scale = require(reader->lastScale(last + 1), kKind)) {
    const bool is_earlier = scale->frame < first_frame;
    point.scale = {scale->is_known,
                   is_earlier ? assembly.system().config.general.earlier() : std::string()};
  }
  point.motion = repeatOdometry(assembly, motions, frames, last, cancellation);
  return point;
}

}  // namespace tolman::engine
