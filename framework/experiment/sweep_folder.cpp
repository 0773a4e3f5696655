// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/sweep_folder.hpp"

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

record::DataDigest digestOf(const Json& data) {
  return {data.at("path"), data.at("files"), data.at("bytes"), data.at("stamp"), data.at("sha256")};
}

PlannedRun runOf(const Json& json, const std::string& folder) {
  PlannedRun run;
  run.folder = folder;
  run.name = json.at("name");
  run.key = json.at("key");
  run.config_sha256 = json.at("config_sha256");
  run.front_end_sha256 = json.at("front_end");
  for (const auto& [name, label] : json.at("factors").items()) run.factors.push_back({name, label});
  run.inputs.host = json.at("host");
  for (const auto& [file, digest] : json.at("plugins").items()) run.inputs.plugins[file] = digest;
  for (const Json& data : json.at("data")) run.inputs.data.push_back(digestOf(data));
  run.front_end_folder = json.at("needs");
  run.answers_folder = json.at("replays");
  run.keeps_answers = json.at("shares");
  run.is_front_end = json.at("is_front_end");
  return run;
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
  const fs::path file = folder / "point.json";
  try {
    return runOf(readJson(file), folder.filename().string());
  } catch (const Json::exception&) {
    return Status::invalidInput(
        file.string() + ": " +
        config::absence(file, "is missing or damaged; is this the folder of a run of a sweep?"));
  }
}

FrozenRuns frozenRuns(const fs::path& sweep) {
  std::map<std::string, std::size_t> order;  // empty where there is no points.txt
  std::ifstream stream(sweep / "points.txt", std::ios::binary);
  for (std::string line; std::getline(stream, line);) order.try_emplace(line, order.size());
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

PointOutcome outcomeOf(const fs::path& folder) {
  const fs::path file = folder / "outcome.json";
  std::error_code ignored;
  if (fs::exists(file, ignored)) {
    try {  // values of other types are those of a failed run
      const Json json = readJson(file);
      const PointState state = config::valueNamed<PointState>(json.at("state").get<std::string>())
                                   .value_or(PointState::Failed);
      const bool is_removed = !fs::exists(folder / "run/run.json", ignored);
      if (state == PointState::Done && is_removed) return {};
      return {state, json.at("exit_code"), json.at("message"), json.at("wall_s"),
              json.at("replayed")};
    } catch (const Json::exception&) {
      return {PointState::Failed, 0, file.string() + ": is damaged; remove it", 0, false};
    }
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
  const Json json = {{"state", enumName(outcome.state)},
                     {"exit_code", outcome.exit_code},
                     {"message", outcome.message},
                     {"wall_s", outcome.wall_s},
                     {"replayed", outcome.replayed}};
  return record::writeAtomically(folder / "outcome.json", config::jsonText(json, 1) + "\n");
}

std::map<std::string, record::DataDigest> readKnownData(const fs::path& sweep) {
  std::map<std::string, record::DataDigest> known;
  try {
    for (const Json& data : readJson(sweep / "data.json")) {
      record::DataDigest digest = digestOf(data);
      known[digest.path] = std::move(digest);
    }
  } catch (const Json::exception&) {
    known.clear();  // the data are read again
  }
  return known;
}

Status writeKnownData(const fs::path& sweep,
                      const std::map<std::string, record::DataDigest>& data) {
  Json json = Json::array();
  for (const auto& [path, one] : data) json.push_back(jsonOf(one));
  return record::writeAtomically(sweep / "data.json", config::jsonText(json, 1) + "\n");
}

}  // namespace tolman::experiment
