// SPDX-License-Identifier: BSD-3-Clause
#include "run/saved_state.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "record/atomic_file.hpp"
#include "record/sha256.hpp"
#include "run/value_json.hpp"

namespace tolman::run {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr const char* kFolder = "state";
constexpr const char* kContents = "session.json";

/// One of the stages whose state a later run needs.
struct SavedStage {
  host::Instance* instance;
  const config::StageConfig* config;
  const ParameterValues* parameters;
};

std::vector<SavedStage> savedStages(Assembly& assembly) {
  std::vector<SavedStage> saved;
  const CheckedSystem& system = assembly.system();
  for (std::size_t i = 0; i < system.config.stages.size(); ++i) {
    const config::StageConfig& stage = system.config.stages[i];
    if (stage.role != Role::Place && stage.role != Role::Cells && stage.role != Role::Map) continue;
    saved.push_back({assembly.instances()[i], &stage, &system.values.find(stage.instance)->second});
  }
  return saved;
}

Json parametersOf(const SavedStage& stage) {
  Json json = Json::object();
  for (const auto& [name, value] : *stage.parameters) json[name] = valueJson(value);
  return json;
}

std::string fileOf(const SavedStage& stage) {
  return std::string(enumName(stage.config->role)) + ".bin";
}

std::string digestOf(const std::string& bytes) {
  record::Sha256 sha;
  sha.add(bytes);
  return sha.digest();
}

[[noreturn]] void refuse(const std::string& what) {
  throw Failed({FailureKind::Continuation, what});
}

std::string textOf(const fs::path& file) {
  std::error_code ignored;
  std::ifstream stream;
  if (fs::is_regular_file(file, ignored)) stream.open(file, std::ios::binary);
  if (!stream.is_open())
    refuse(file.string() + ": cannot be read; the saved session is not complete");
  return {std::istreambuf_iterator<char>(stream), {}};
}

Json contentsOf(const fs::path& folder) {
  const fs::path file = folder / kContents;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    refuse(folder.parent_path().string() +
           ": this run saved no map that could be continued (it was killed, failed, or is of an "
           "older version); run it again to its end or to an interrupt");
  }
  Json json = Json::parse(textOf(file), nullptr, false);
  if (!json.is_object()) refuse(file.string() + ": is damaged; run the earlier session again");
  const int format = json.at("format").get<int>();
  if (format != kFormat) {
    refuse(file.string() + ": has format " + std::to_string(format) + ", this program reads " +
           std::to_string(kFormat) + "; use the version of Tolman that wrote it");
  }
  return json;
}

const Json& entryOf(const Json& contents, const SavedStage& stage, const fs::path& folder) {
  const std::string role(enumName(stage.config->role));
  for (const Json& entry : contents.at("stages")) {
    if (entry.at("role") == role) return entry;
  }
  refuse(folder.parent_path().string() + ": its " + role +
         " saved no state; its plugin cannot. Choose one that can, such as those of "
         "configs/motion.yaml");
}

/// The first parameter that differs: "cells.period is 12, and was 15".
void compareParameters(const Json& then, const Json& now, const std::string& stage,
                       const std::string& remedy) {
  for (const auto& [name, value] : now.items()) {
    const auto old = then.find(name);
    if (old != then.end() && *old == value) continue;
    refuse(fmt::format("{}.{} is {}, and was {} in the earlier session; {}", stage, name,
                       value.dump(), old == then.end() ? "unknown" : old->dump(), remedy));
  }
}

void checkEntry(const Json& entry, const SavedStage& stage, const fs::path& folder) {
  const std::string& name = stage.config->path;
  const std::string remedy = "configure it as in " +
                             (folder.parent_path() / "config.resolved.yaml").string() +
                             ", or start a new map";
  const auto plugin = entry.at("plugin").get<std::string>();
  const auto version = entry.at("version").get<std::string>();
  const host::Manifest& manifest = stage.instance->manifest();
  if (plugin != manifest.id) {
    refuse(name + ": is '" + manifest.id + "', and was '" + plugin + "' in the earlier session; " +
           remedy);
  }
  if (version != manifest.version) {
    refuse(name + ": '" + plugin + "' has version " + manifest.version + ", and had " + version +
           " in the earlier session; use that version, or start a new map");
  }
  compareParameters(entry.at("parameters"), parametersOf(stage), name, remedy);
}

void loadStage(const Json& contents, const SavedStage& stage, const fs::path& folder) {
  const Json& entry = entryOf(contents, stage, folder);
  checkEntry(entry, stage, folder);
  const fs::path file = folder / fileOf(stage);
  const std::string bytes = textOf(file);
  if (digestOf(bytes) != entry.at("sha256").get<std::string>()) {
    refuse(file.string() +
           ": is damaged, its digest does not agree; run the earlier session again");
  }
  const Status status = stage.instance->load(bytes);
  if (!status.isOk()) refuse(file.string() + ": " + status.message());
}

SessionProgress loadAll(Assembly& assembly, const fs::path& directory) {
  const fs::path folder = directory / kFolder;
  const Json contents = contentsOf(folder);
  for (const SavedStage& stage : savedStages(assembly)) loadStage(contents, stage, folder);
  SessionProgress progress;
  progress.frames = contents.at("frames").get<std::int64_t>();
  progress.experiences = contents.at("experiences").get<std::int64_t>();
  progress.templates = contents.at("templates").get<std::int64_t>();
  MapGraph graph;
  require(assembly.map().graph(graph), FailureKind::Continuation);
  if (progress.frames < 1 || progress.templates < -1 ||
      progress.experiences != static_cast<std::int64_t>(graph.experiences.size())) {
    refuse((folder / kContents).string() +
           ": is damaged, it does not agree with the map; run the earlier session again");
  }
  return progress;
}

}  // namespace

std::optional<Failure> saveState(Assembly& assembly, const fs::path& directory,
                                 const SessionProgress& progress) {
  const fs::path folder = directory / kFolder;
  std::error_code error;
  Json stages = Json::array();
  for (const SavedStage& stage : savedStages(assembly)) {
    if (stage.instance->state() == nullptr) continue;
    const Result<std::string> bytes = stage.instance->save();
    if (!bytes.isOk()) {
      return Failure{FailureKind::Stage, bytes.status().message(), stage.instance->name()};
    }
    fs::create_directories(folder, error);
    const Status status = record::writeAtomically(folder / fileOf(stage), bytes.value());
    if (!status.isOk()) return Failure{FailureKind::Record, status.message()};
    stages.push_back({{"role", enumName(stage.config->role)},
                      {"plugin", stage.instance->manifest().id},
                      {"version", stage.instance->manifest().version},
                      {"parameters", parametersOf(stage)},
                      {"file", fileOf(stage)},
                      {"bytes", bytes.value().size()},
                      {"sha256", digestOf(bytes.value())}});
  }
  if (stages.empty()) return std::nullopt;
  const Json contents = {{"format", kFormat},
                         {"frames", progress.frames},
                         {"experiences", progress.experiences},
                         {"templates", progress.templates},
                         {"stages", stages}};
  const Status status = record::writeAtomically(folder / kContents, contents.dump(2) + "\n");
  if (!status.isOk()) return Failure{FailureKind::Record, status.message()};
  return std::nullopt;
}

SessionProgress loadState(Assembly& assembly, const fs::path& directory) {
  try {
    return loadAll(assembly, directory);
  } catch (const Json::exception&) {
    refuse((directory / kFolder / kContents).string() +
           ": is damaged; run the earlier session again");
  }
}

}  // namespace tolman::run
