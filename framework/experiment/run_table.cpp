// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/run_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "config/loader.hpp"
#include "experiment/point_folder.hpp"
#include "record/digest.hpp"
#include "record/run_reader.hpp"
#include "record/sha256.hpp"

namespace tolman::experiment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void flatten(const Json& json, const std::string& path, std::map<std::string, double>& numbers) {
  if (json.is_number()) numbers[path] = json.get<double>();
  if (!json.is_structured()) return;
  for (const auto& [key, value] : json.items()) {
    if (path.empty() && (key == "timing" || key == "sessions")) continue;
    flatten(value, path.empty() ? key : path + "." + key, numbers);
  }
}

std::string truthDigest(const fs::path& directory) {
  const auto reader = record::RunReader::open(directory);
  if (!reader.isOk()) return "";
  const auto truth = reader.value()->truth();
  if (!truth.isOk() || truth.value().empty()) return "";
  record::Sha256 sha;
  for (const auto& pose : truth.value()) {
    sha.add(std::as_bytes(std::span(&pose.frame, 1)));
    sha.add(std::as_bytes(std::span(pose.T_world_camera.matrix().data(), 16)));
  }
  return sha.digest();
}

Result<RunRow> readRun(const fs::path& directory) {
  RunRow row;
  row.directory = directory;
  row.name = fs::absolute(directory).lexically_normal().filename().string();
  std::ifstream stream(directory / "metrics.json", std::ios::binary);
  const Json metrics = Json::parse(stream, nullptr, false);
  if (!metrics.is_object()) {
    return Status::invalidInput(
        (directory / "metrics.json").string() +
        ": is missing or damaged; is this a run that has ended, or a sweep?");
  }
  flatten(metrics, "", row.metrics);
  row.alignment = metrics.value("alignment", "");
  row.truth = truthDigest(directory);
  const auto digest = record::fileDigest(directory / "results.sha256");
  if (digest.isOk()) row.results = digest.value();
  return row;
}

void leaves(const config::Node& node, const std::string& path,
            std::map<std::string, std::string>& values) {
  if (node.isScalar()) values[path] = node.text;
  for (const config::Node& child : node.children) {
    leaves(child, config::joinPath(path, child.key), values);
  }
}

/// Keys of the configurations that are not the same in all runs become factors.
void addConfigFactors(std::vector<RunRow*>& rows) {
  std::vector<std::map<std::string, std::string>> configs;
  std::map<std::string, std::set<std::string>> values;
  for (const RunRow* row : rows) {
    const auto loaded = config::load(row->directory / "config.resolved.yaml", {},
                                     [](const std::string&) { return std::nullopt; });
    leaves(loaded.tree, "", configs.emplace_back());
    for (const auto& [key, value] : configs.back()) values[key].insert(value);
  }
  for (const auto& [key, different] : values) {
    const bool everywhere = std::ranges::all_of(
        configs, [&, &key = key](const auto& config) { return config.contains(key); });
    if (different.size() < 2 && everywhere) continue;
    if (key == "threads" || key == "name") continue;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto own = configs[i].find(key);
      rows[i]->factors.push_back({key, own == configs[i].end() ? "-" : own->second});
    }
  }
}

}  // namespace

std::string RunRow::label(const std::string& factor) const {
  const auto found = std::ranges::find(factors, factor, &Factor::name);
  return found == factors.end() ? "" : found->label;
}

Result<std::vector<RunRow>> readRunRows(const std::vector<fs::path>& folders) {
  std::vector<RunRow> rows;
  std::vector<std::size_t> alone;
  for (const fs::path& folder : folders) {
    const auto points = readPoints(folder);
    for (const PlannedRun& point : points) {
      if (point.is_front_end) continue;
      const PointOutcome outcome = outcomeOf(folder / point.folder);
      if (outcome.state != PointState::Done) continue;
      auto row = readRun(folder / point.folder / "run");
      if (!row.isOk()) return row.status();
      row.value().name = point.name;
      row.value().factors = point.factors;
      row.value().metrics["exit_code"] = outcome.exit_code;
      rows.push_back(std::move(row).value());
    }
    if (!points.empty()) continue;
    auto row = readRun(folder);
    if (!row.isOk()) return row.status();
    alone.push_back(rows.size());
    rows.push_back(std::move(row).value());
  }
  std::vector<RunRow*> others;
  for (const std::size_t i : alone) others.push_back(&rows[i]);
  addConfigFactors(others);
  return rows;
}

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

std::string csvOf(const std::vector<RunRow>& rows) {
  std::vector<std::string> factors;
  std::set<std::string> metrics;
  for (const RunRow& row : rows) {
    for (const Factor& factor : row.factors) {
      if (std::ranges::find(factors, factor.name) == factors.end()) factors.push_back(factor.name);
    }
    for (const auto& [name, value] : row.metrics) metrics.insert(name);
  }
  std::string text = "name";
  for (const std::string& factor : factors) text += "," + csvField(factor);
  text += ",alignment,results_sha256";
  for (const std::string& metric : metrics) text += "," + csvField(metric);
  text += "\n";
  for (const RunRow& row : rows) {
    text += csvField(row.name);
    for (const std::string& factor : factors) text += "," + csvField(row.label(factor));
    text += "," + row.alignment + "," + row.results;
    for (const std::string& metric : metrics) {
      const auto value = row.metrics.find(metric);
      text += value == row.metrics.end() ? "," : fmt::format(",{:.17g}", value->second);
    }
    text += "\n";
  }
  return text;
}

}  // namespace tolman::experiment
