// SPDX-License-Identifier: BSD-3-Clause
#include "engine/state_files.hpp"

#include <fmt/format.h>

#include <iterator>

#include "base/bounded_json.hpp"
#include "config/json_text.hpp"
#include "engine/value_json.hpp"
#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/regular_file.hpp"
#include "record/run_id.hpp"

namespace tolman::run {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr const char* kRun = "run";

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

std::string fileOf(const std::string& prefix, const SavedStage& stage) {
  return prefix + std::string(enumName(stage.config->role)) + ".bin";
}

std::string textOf(const fs::path& file) {
  std::ifstream stream = record::openRegular(file);
  if (!stream.is_open())
    refuseToContinue(file.string() + ": cannot be read; the saved session is not complete");
  return {std::istreambuf_iterator<char>(stream), {}};
}

const Json& entryOf(const Json& contents, const SavedStage& stage, const fs::path& folder) {
  const std::string role(enumName(stage.config->role));
  for (const Json& entry : contents.at("stages")) {
    if (entry.at("role") == role) return entry;
  }
  refuseToContinue(folder.parent_path().string() + ": its " + role +
                   " saved no state; its plugin cannot. Choose one that can, such as those of "
                   "configs/motion.yaml");
}

/// Throws Failed for the first parameter that differs: "cells.period is 12, and was 15".
void compareParameters(const Json& then, const Json& now, const std::string& stage,
                       const std::string& remedy) {
  for (const auto& [name, value] : now.items()) {
    const auto old = then.find(name);
    if (old != then.end() && *old == value) continue;
    refuseToContinue(fmt::format("{}.{} is {}, and was {} in the earlier session; {}", stage, name,
                                 value.dump(), old == then.end() ? "unknown" : old->dump(),
                                 remedy));
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
    refuseToContinue(name + ": is '" + manifest.id + "', and was '" + plugin +
                     "' in the earlier session; " + remedy);
  }
  if (version != manifest.version) {
    refuseToContinue(name + ": '" + plugin + "' has version " + manifest.version + ", and had " +
                     version + " in the earlier session; use that version, or start a new map");
  }
  compareParameters(entry.at("parameters"), parametersOf(stage), name, remedy);
}

void loadStage(const Json& contents, const std::string& prefix, const SavedStage& stage,
               const fs::path& folder) {
  const Json& entry = entryOf(contents, stage, folder);
  checkEntry(entry, stage, folder);
  const fs::path file = folder / fileOf(prefix, stage);
  const std::string bytes = textOf(file);
  if (record::textDigest(bytes) != entry.at("sha256").get<std::string>()) {
    refuseToContinue(file.string() +
                     ": is damaged, its digest does not agree; run the earlier session again");
  }
  const Status status = stage.instance->load(bytes);
  if (!status.isOk()) refuseToContinue(file.string() + ": " + status.message());
}

}  // namespace

Result<std::map<Role, std::string>> savedStates(Assembly& assembly) {
  std::map<Role, std::string> states;
  for (const SavedStage& stage : savedStages(assembly)) {
    if (stage.instance->state() == nullptr) continue;
    Result<std::string> bytes = stage.instance->save();
    if (!bytes.isOk()) return bytes.status();
    states[stage.config->role] = std::move(bytes).value();
  }
  return states;
}

Status writeStates(Assembly& assembly, const fs::path& file, const std::string& prefix,
                   const std::map<Role, std::string>& states, Json contents) {
  const fs::path folder = file.parent_path();
  std::error_code error;
  // Does not create parents, because the run directory may have been moved. On failure writing the
  // files fails.
  fs::create_directory(folder, error);
  contents["format"] = kFormat;
  contents[kRun] = record::runIdOf(folder.parent_path());
  contents["stages"] = Json::array();
  for (const SavedStage& stage : savedStages(assembly)) {
    const auto state = states.find(stage.config->role);
    if (state == states.end()) continue;
    const std::string name = fileOf(prefix, stage);
    const Status status = record::writeAtomically(folder / name, state->second);
    if (!status.isOk()) return status;
    contents["stages"].push_back({{"role", enumName(stage.config->role)},
                                  {"plugin", stage.instance->manifest().id},
                                  {"version", stage.instance->manifest().version},
                                  {"parameters", parametersOf(stage)},
                                  {"file", name},
                                  {"bytes", state->second.size()},
                                  {"sha256", record::textDigest(state->second)}});
  }
  return record::writeAtomically(file, config::jsonText(contents, 2) + "\n");
}

Json readContents(const fs::path& file) {
  Json json = bounded_json::parse<Json>(textOf(file));
  if (!json.is_object())
    refuseToContinue(file.string() + ": is damaged; run the earlier session again");
  const int format = config::integerFrom<int>(json.at("format"));
  if (format != kFormat) {
    refuseToContinue(file.string() + ": has format " + std::to_string(format) +
                     ", this program reads " + std::to_string(kFormat) +
                     "; use the version of Tolman that wrote it");
  }
  const std::string run = record::runIdOf(file.parent_path().parent_path());
  if (!run.empty()) {
    const Status of_run = record::isOfRun(file, json.at(kRun).get<std::string>(), run);
    if (!of_run.isOk()) refuseToContinue(of_run.message());
  }
  return json;
}

void loadStates(Assembly& assembly, const fs::path& file, const std::string& prefix,
                const Json& contents) {
  for (const SavedStage& stage : savedStages(assembly)) {
    loadStage(contents, prefix, stage, file.parent_path());
  }
}

}  // namespace tolman::run
