// SPDX-License-Identifier: BSD-3-Clause
#include "app/saved_session.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "app/parameter_text.hpp"
#include "record/atomic_file.hpp"
#include "record/sha256.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr const char* kFolder = "state";
constexpr const char* kContents = "session.json";

/// One of the three stages that a session leaves to the next.
struct Keeper {
  plugins::Instance* instance;
  const config::StageConfig* config;
  const ParameterValues* parameters;
};

std::vector<Keeper> keepersOf(Assembly& assembly) {
  std::vector<Keeper> keepers;
  const CheckedSystem& system = assembly.system();
  const std::array<std::pair<Role, plugins::Instance*>, 3> stages = {
      std::pair{Role::Place, &assembly.place().instance()},
      std::pair{Role::Cells, &assembly.cells().instance()},
      std::pair{Role::Map, &assembly.map().instance()}};
  for (const auto& [role, instance] : stages) {
    for (const config::StageConfig& stage : system.config.stages) {
      if (stage.role != role) continue;
      keepers.push_back({instance, &stage, &system.values.find(stage.instance)->second});
    }
  }
  return keepers;
}

Json parametersOf(const Keeper& keeper) {
  Json json = Json::object();
  for (const auto& [name, value] : *keeper.parameters) json[name] = valueJson(value);
  return json;
}

std::string fileOf(const Keeper& keeper) {
  return std::string(enumName(keeper.config->role)) + ".bin";
}

std::string digestOf(const std::string& bytes) {
  record::Sha256 sha;
  sha.add(bytes);
  return sha.digest();
}

/// What cannot be gone on with, as a sentence.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] void refuse(const std::string& what) { throw Refused(what); }

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(file.string() + ": cannot be read; the saved session is not complete");
  return {std::istreambuf_iterator<char>(stream), {}};
}

Json contentsOf(const fs::path& folder) {
  const fs::path file = folder / kContents;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    refuse(folder.parent_path().string() +
           ": this run has left no map to go on with (it was killed, failed, or is of an older "
           "version); run it again to its end or to an interrupt");
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

const Json& entryOf(const Json& contents, const Keeper& keeper, const fs::path& folder) {
  const std::string role(enumName(keeper.config->role));
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

void checkEntry(const Json& entry, const Keeper& keeper, const fs::path& folder) {
  const std::string& stage = keeper.config->path;
  const std::string remedy = "configure it as in " +
                             (folder.parent_path() / "config.resolved.yaml").string() +
                             ", or begin a new map";
  const auto plugin = entry.at("plugin").get<std::string>();
  const auto version = entry.at("version").get<std::string>();
  const plugins::Manifest& manifest = keeper.instance->manifest();
  if (plugin != manifest.id) {
    refuse(stage + ": is '" + manifest.id + "', and was '" + plugin + "' in the earlier session; " +
           remedy);
  }
  if (version != manifest.version) {
    refuse(stage + ": '" + plugin + "' has version " + manifest.version + ", and had " + version +
           " in the earlier session; use that version, or begin a new map");
  }
  compareParameters(entry.at("parameters"), parametersOf(keeper), stage, remedy);
}

void loadStage(const Json& contents, const Keeper& keeper, const fs::path& folder) {
  const Json& entry = entryOf(contents, keeper, folder);
  checkEntry(entry, keeper, folder);
  const fs::path file = folder / fileOf(keeper);
  const std::string bytes = textOf(file);
  if (digestOf(bytes) != entry.at("sha256").get<std::string>()) {
    refuse(file.string() +
           ": is damaged, its digest does not agree; run the earlier session again");
  }
  const Status status = keeper.instance->load(bytes);
  if (!status.isOk()) refuse(file.string() + ": " + status.message());
}

Progress loadAll(Assembly& assembly, const fs::path& directory) {
  const fs::path folder = directory / kFolder;
  const Json contents = contentsOf(folder);
  for (const Keeper& keeper : keepersOf(assembly)) loadStage(contents, keeper, folder);
  Progress progress;
  progress.frames = contents.at("frames").get<std::int64_t>();
  progress.experiences = contents.at("experiences").get<std::int64_t>();
  progress.templates = contents.at("templates").get<std::int64_t>();
  MapGraph graph;
  const Status status = assembly.map().graph(graph);
  if (!status.isOk()) refuse(status.message());
  if (progress.frames < 1 || progress.templates < -1 ||
      progress.experiences != static_cast<std::int64_t>(graph.experiences.size())) {
    refuse((folder / kContents).string() +
           ": is damaged, it does not agree with the map; run the earlier session again");
  }
  return progress;
}

}  // namespace

Status saveSession(Assembly& assembly, const fs::path& directory, const Progress& progress) {
  const fs::path folder = directory / kFolder;
  std::error_code error;
  Json stages = Json::array();
  for (const Keeper& keeper : keepersOf(assembly)) {
    if (keeper.instance->state() == nullptr) continue;
    const Result<std::string> bytes = keeper.instance->save();
    if (!bytes.isOk()) return bytes.status();
    fs::create_directories(folder, error);
    const Status status = record::writeAtomically(folder / fileOf(keeper), bytes.value());
    if (!status.isOk()) return status;
    stages.push_back({{"role", enumName(keeper.config->role)},
                      {"plugin", keeper.instance->manifest().id},
                      {"version", keeper.instance->manifest().version},
                      {"parameters", parametersOf(keeper)},
                      {"file", fileOf(keeper)},
                      {"bytes", bytes.value().size()},
                      {"sha256", digestOf(bytes.value())}});
  }
  if (stages.empty()) return Status::ok();
  const Json contents = {{"format", kFormat},
                         {"frames", progress.frames},
                         {"experiences", progress.experiences},
                         {"templates", progress.templates},
                         {"stages", stages}};
  return record::writeAtomically(folder / kContents, contents.dump(2) + "\n");
}

std::variant<Progress, Failure> loadSession(Assembly& assembly, const fs::path& directory) {
  try {
    return loadAll(assembly, directory);
  } catch (const Refused& refused) {
    return Failure{ExitCode::Session, refused.what()};
  } catch (const Json::exception&) {
    return Failure{ExitCode::Session, (directory / kFolder / kContents).string() +
                                          ": is damaged; run the earlier session again"};
  }
}

}  // namespace tolman::app
