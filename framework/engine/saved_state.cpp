// SPDX-License-Identifier: BSD-3-Clause
#include "engine/saved_state.hpp"

#include <fmt/format.h>

#include "config/json_text.hpp"
#include "engine/provenance.hpp"
#include "engine/state_files.hpp"

namespace tolman::run {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kCheckpoint = "checkpoint";

fs::path sessionFile(const fs::path& directory) { return directory / "state" / "session.json"; }

fs::path checkpointFile(const fs::path& directory) {
  return directory / "state" / "checkpoint.json";
}

/// The common prefix of the files of one checkpoint.
std::string prefixOf(std::int64_t frame) {
  return std::string(kCheckpoint) + "-" + std::to_string(frame) + "-";
}

[[noreturn]] void refuseDamaged(const fs::path& file) {
  refuseToContinue(file.string() + ": is damaged; run the earlier session again");
}

std::int64_t experiencesOf(Assembly& assembly) {
  MapGraph graph;
  require(assembly.map().graph(graph), FailureKind::Continuation);
  return static_cast<std::int64_t>(graph.experiences.size());
}

SessionProgress loadSession(Assembly& assembly, const fs::path& file) {
  const Json contents = readContents(file);
  loadStates(assembly, file, "", contents);
  SessionProgress progress;
  progress.frames = config::integerFrom<std::int64_t>(contents.at("frames"));
  progress.experiences = config::integerFrom<std::int64_t>(contents.at("experiences"));
  progress.templates = config::integerFrom<std::int64_t>(contents.at("templates"));
  if (progress.frames < 1 || progress.templates < -1) refuseDamaged(file);
  if (const std::int64_t loaded = experiencesOf(assembly); progress.experiences != loaded) {
    refuseToContinue(fmt::format(
        "{}: has {} experiences, the map that was loaded {}; the file is damaged, or the map's "
        "plugin does not load what it saved; run the earlier session again",
        file.string(), progress.experiences, loaded));
  }
  return progress;
}

/// Calls `load(file)`, and reports JSON of a wrong shape as a damaged file.
template <class Load>
auto loaded(const fs::path& file, const Load& load) {
  try {
    return load(file);
  } catch (const Json::exception&) {
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

std::optional<Failure> saveState(Assembly& assembly, const fs::path& directory,
                                 const SessionProgress& progress) {
  const Result<std::map<Role, std::string>> states = savedStates(assembly);
  if (!states.isOk())
    return Failure{kindOf(states.status(), FailureKind::Stage), states.status().message()};
  if (states.value().empty()) return std::nullopt;
  const Status status = writeStates(assembly, sessionFile(directory), "", states.value(),
                                    {{"frames", progress.frames},
                                     {"experiences", progress.experiences},
                                     {"templates", progress.templates}});
  if (!status.isOk()) return Failure{FailureKind::Record, status.message()};
  return std::nullopt;
}

SessionProgress loadState(Assembly& assembly, const fs::path& directory) {
  const fs::path file = sessionFile(directory);
  std::error_code ignored;
  if (fs::exists(file, ignored)) {
    return loaded(file, [&](const fs::path& session) { return loadSession(assembly, session); });
  }
  if (!fs::exists(checkpointFile(directory), ignored)) {
    refuseToContinue(
        directory.string() +
        ": this run saved no map that could be continued (it failed, was killed before its first "
        "checkpoint, is of an older version, or its plugins cannot save their state; see its "
        "log.txt); run it again to its end or to an interrupt");
  }
  SessionProgress progress;
  progress.frames = loadCheckpoint(assembly, directory).frame + 1;
  progress.experiences = experiencesOf(assembly);
  progress.finished = false;
  return progress;
}

Status saveCheckpoint(Assembly& assembly, const fs::path& directory,
                      const pipeline::Checkpoint& checkpoint) {
  const fs::path file = checkpointFile(directory);
  const Status status =
      writeStates(assembly, file, prefixOf(checkpoint.frame), checkpoint.states,
                  {{"frame", checkpoint.frame}, {"counters", countersJson(checkpoint.counters)}});
  if (status.isOk()) removeCheckpointsBut(file.parent_path(), checkpoint.frame);
  return status;
}

pipeline::Checkpoint loadCheckpoint(Assembly& assembly, const fs::path& directory) {
  std::error_code ignored;
  if (!fs::exists(checkpointFile(directory), ignored)) {
    refuseToContinue(directory.string() +
                     ": has no checkpoint (it ended before the first one, see record.state_every, "
                     "or place, cells or map cannot save their state); run it again");
  }
  return loaded(checkpointFile(directory), [&](const fs::path& file) {
    const Json contents = readContents(file);
    pipeline::Checkpoint checkpoint;
    checkpoint.frame = config::integerFrom<std::int64_t>(contents.at("frame"));
    if (checkpoint.frame < 0) refuseDamaged(file);
    pipeline::RunCounters::visit(checkpoint.counters, [&](const char* name, auto& value) {
      const Json& count = contents.at("counters").at(name);
      if constexpr (std::is_same_v<decltype(value), bool&>) {
        count.get_to(value);
      } else {
        value = config::integerFrom<std::int64_t>(count);
      }
    });
    loadStates(assembly, file, prefixOf(checkpoint.frame), contents);
    return checkpoint;
  });
}

void removeCheckpoint(const fs::path& directory) {
  std::error_code ignored;  // a remaining checkpoint does no harm
  if (!fs::exists(sessionFile(directory), ignored)) return;
  fs::remove(checkpointFile(directory), ignored);
  removeCheckpointsBut(sessionFile(directory).parent_path(), -1);
}

}  // namespace tolman::run
