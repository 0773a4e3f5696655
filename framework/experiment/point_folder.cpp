// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/point_folder.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/bounded_json.hpp"
#include "config/json_text.hpp"
#include "config/text.hpp"
#include "config/values.hpp"
#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/run_directory.hpp"

namespace tolman::experiment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json jsonOf(const record::DataDigest& data) {
  return {{"path", data.path},
          {"files", data.files},
          {"bytes", data.bytes},
          {"stamp", data.stamp},
          {"sha256", data.sha256}};
}

Json jsonOf(const PlannedRun& run) {
  Json factors = Json::object();
  for (const Factor& factor : run.factors) factors[factor.name] = factor.label;
  Json plugins = Json::object();
  for (const auto& [file, digest] : run.inputs.plugins) plugins[file] = digest;
  Json data = Json::array();
  for (const record::DataDigest& one : run.inputs.data) data.push_back(jsonOf(one));
  return {{"name", run.name},
          {"key", run.key},
          {"config_sha256", record::textDigest(run.config)},
          {"front_end", run.front_end_sha256},
          {"factors", factors},
          {"host", run.inputs.host},
          {"plugins", plugins},
          {"data", data},
          {"needs", run.front_end_folder},
          {"replays", run.answers_folder},
          {"shares", run.keeps_answers},
          {"is_front_end", run.is_front_end}};
}

/// A folder's name ends with the first characters of its run's key, so that point.json and results
/// that are copied from another run are detected.
bool isOwn(const Json& point, const fs::path& folder) {
  const auto found = point.find("key");
  if (found == point.end() || !found->is_string()) return false;
  return folder.filename().string().ends_with(folderEnding(found->get<std::string>()));
}

PlannedRun runOf(const Json& json, const std::string& folder) {
  PlannedRun run;
  run.folder = folder;
  run.name = json.at("name");
  run.key = json.at("key");
  run.config_sha256 = json.value("config_sha256", "");  // sweeps of earlier versions have none
  run.front_end_sha256 = json.at("front_end");
  for (const auto& [name, label] : json.at("factors").items()) run.factors.push_back({name, label});
  run.inputs.host = json.at("host");
  for (const auto& [file, digest] : json.at("plugins").items()) run.inputs.plugins[file] = digest;
  for (const Json& data : json.at("data")) {
    run.inputs.data.push_back(
        {data.at("path"), data.at("files"), data.at("bytes"), data.at("stamp"), data.at("sha256")});
  }
  run.front_end_folder = json.at("needs");
  run.answers_folder = json.at("replays");
  run.keeps_answers = json.at("shares");
  run.is_front_end = json.at("is_front_end");
  return run;
}

constexpr std::array<const char*, 2> kFigures = {"metrics.json", "results.sha256"};

Json figureDigests(const fs::path& run) {
  Json digests = Json::object();
  for (const char* file : kFigures) {
    const auto digest = record::fileDigest(run / file);
    if (digest.isOk()) digests[file] = digest.value();
  }
  return digests;
}

/// Sweeps of earlier versions have no digests.
PointOutcome withOwnFigures(PointOutcome outcome, const Json& json, const fs::path& run) {
  if (outcome.state != PointState::Done || !json.contains("digests")) return outcome;
  const Json now = figureDigests(run);
  std::vector<std::string> changed;
  for (const char* file : kFigures) {
    if (json["digests"].value(file, "") != now.value(file, "")) changed.emplace_back(file);
  }
  if (changed.empty()) std::ranges::copy(record::changedResults(run), std::back_inserter(changed));
  if (changed.empty()) return outcome;
  outcome.state = PointState::Failed;
  outcome.message = (run / changed.front()).string() +
                    ": is not the file that this run wrote; run it again with --retry";
  return outcome;
}

/// A file with values of other types is the outcome of a failed run.
PointOutcome writtenOutcome(const Json& json, const fs::path& folder) {
  try {
    const auto state = config::valueNamed<PointState>(json.value("state", ""));
    return withOwnFigures(
        {state.value_or(PointState::Failed), json.value("exit_code", 0), json.value("message", ""),
         json.value("wall_s", 0.0), json.value("replayed", false)},
        json, folder / "run");
  } catch (const Json::exception&) {
    return {PointState::Failed, 0, (folder / "outcome.json").string() + ": is damaged; remove it",
            0, false};
  }
}

Json readJson(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return bounded_json::parse<Json>(stream);
}

}  // namespace

Status freeze(const fs::path& sweep, const PlannedRun& run) {
  const fs::path folder = sweep / run.folder;
  std::error_code error;
  if (fs::exists(folder / "point.json", error)) return Status::ok();
  fs::create_directories(folder, error);
  if (error) return Status::failed(folder.string() + ": " + error.message());
  const Status written =
      record::writeAtomically(folder / "config.yaml", run.config, record::Sync::No);
  if (!written.isOk()) return written;
  return record::writeAtomically(folder / "point.json", config::jsonText(jsonOf(run), 1) + "\n",
                                 record::Sync::No);
}

Result<PlannedRun> readPoint(const fs::path& folder) {
  try {
    const Json point = readJson(folder / "point.json");
    if (point.is_object() && !isOwn(point, folder)) {
      return Status::invalidInput((folder / "point.json").string() +
                                  ": is of another run, whose key is not in the folder's name; "
                                  "remove the folder and plan again with `tolman sweep`");
    }
    return runOf(point, folder.filename().string());
  } catch (const Json::exception&) {
    const fs::path file = folder / "point.json";
    return Status::invalidInput(
        file.string() + ": " +
        config::absence(file, "is missing or damaged; is this the folder of a run of a sweep?"));
  }
}

FrozenRuns frozenRuns(const fs::path& sweep) {
  std::map<std::string, std::size_t> order;
  for (const std::string& folder : planOrder(sweep)) order.try_emplace(folder, order.size());
  FrozenRuns runs;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(sweep, error)) {
    if (!fs::exists(entry.path() / "point.json", error)) continue;
    auto run = readPoint(entry.path());
    if (!run.isOk()) continue;
    const bool planned = order.empty() || order.contains(run.value().folder);
    (planned ? runs.planned : runs.earlier).push_back(std::move(run).value());
  }
  for (const auto& [folder, place] : order) {
    if (std::ranges::find(runs.planned, folder, &PlannedRun::folder) == runs.planned.end()) {
      runs.missing.push_back(folder);
    }
  }
  std::ranges::sort(runs.earlier, {}, &PlannedRun::folder);
  std::ranges::sort(runs.planned, {}, [&](const PlannedRun& run) {
    return std::pair(order.empty() ? 0 : order.at(run.folder), run.folder);
  });
  return runs;
}

Status writePlanOrder(const fs::path& sweep, const std::vector<PlannedRun>& runs) {
  std::string text;
  for (const PlannedRun& run : runs) text += run.folder + "\n";
  return record::writeAtomically(sweep / "points.txt", text, record::Sync::No);
}

std::vector<std::string> planOrder(const fs::path& sweep) {
  std::vector<std::string> folders;
  std::ifstream stream(sweep / "points.txt", std::ios::binary);
  for (std::string line; std::getline(stream, line);) folders.push_back(line);
  return folders;
}

PointOutcome outcomeOf(const fs::path& folder) {
  const Json json = readJson(folder / "outcome.json");
  const Json point = readJson(folder / "point.json");
  std::error_code ignored;
  if (point.is_object() && !isOwn(point, folder)) {
    return {PointState::Failed, 0,
            (folder / "point.json").string() +
                ": is of another run, whose key is not in the folder's name; remove the folder",
            0, false};
  }
  if (json.is_object()) {
    const bool removed = !fs::exists(folder / "run/run.json", ignored);
    const bool was_done = json.value("state", Json()) == enumName(PointState::Done);
    return was_done && removed ? PointOutcome() : writtenOutcome(json, folder);
  }
  PointOutcome outcome;
  if (record::RunDirectory::isBeingWritten(folder)) {
    outcome.state = PointState::Running;
  } else if (fs::exists(folder / "run", ignored)) {
    outcome.state = PointState::Interrupted;
  }
  return outcome;
}

Status writeOutcome(const fs::path& folder, const PointOutcome& outcome) {
  const Json json = {
      {"state", enumName(outcome.state)}, {"exit_code", outcome.exit_code},
      {"message", outcome.message},       {"wall_s", outcome.wall_s},
      {"replayed", outcome.replayed},     {"digests", figureDigests(folder / "run")}};
  return record::writeAtomically(folder / "outcome.json", config::jsonText(json, 1) + "\n");
}

}  // namespace tolman::experiment
