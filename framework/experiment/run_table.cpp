// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/must.hpp"
#include "base/text_file.hpp"
#include "config/loader.hpp"
#include "config/tree.hpp"
#include "config/values.hpp"
#include "engine/results.hpp"
#include "experiment/comparison.hpp"
#include "experiment/sweep_folder.hpp"
#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/run_directory.hpp"

namespace tolman::experiment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void flatten(const Json& json, const std::string& path, std::map<std::string, double>& numbers) {
  if (json.is_number()) numbers[path] = json.get<double>();
  if (json.is_boolean()) numbers[path] = json.get<bool>() ? 1 : 0;
  if (!json.is_structured()) return;
  for (const auto& [key, value] : json.items()) {
    if (path.empty() && key == "sessions") continue;
    flatten(value, path.empty() ? key : fmt::format("{}.{}", path, key), numbers);
  }
}

/// Whether a comparison needs a metric to refuse runs that must not be averaged.
bool isNeeded(const std::string& metric) {
  return metric == "map.coverage" || metric == "exit_code" ||
         metric.find(".kitti.lengths_m.") != std::string::npos;
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw Refused{Status::invalidInput(file.string() + ": " + why)};
}

[[noreturn]] void refuseWithoutMetrics(const fs::path& directory) {
  std::error_code ignored;
  if (!fs::exists(directory, ignored)) {
    refuse(directory, config::absence(directory, "does not exist; check the path"));
  }
  if (fs::exists(directory / "points.txt", ignored)) {
    refuse(directory,
           "is a sweep of which no run has ended, so there is nothing to compare; run it again");
  }
  const fs::path file = directory / "metrics.json";
  refuse(file,
         config::absence(file, "is missing or damaged; is this a run that has ended, or a sweep?"));
}

RunRow readRun(const fs::path& directory) {
  std::ifstream stream(directory / "metrics.json", std::ios::binary);
  const Json metrics = Json::parse(stream, nullptr, false);
  if (!metrics.is_object()) refuseWithoutMetrics(directory);
  RunRow row;
  row.directory = directory;
  flatten(metrics, "", row.metrics);
  const Json run = record::RunDirectory::readRunFile(directory);
  std::error_code ignored;
  if (run.is_object()) {
    flatten(run.value("finish_s", Json()), "finish_s", row.metrics);
    flatten(run.value("exit_code", Json()), "exit_code", row.metrics);
  } else if (fs::exists(directory / "run.json", ignored)) {
    must(record::RunDirectory::checkRunFile(directory));
  }
  row.alignment = metrics.value("alignment", "");
  const Json truth = metrics.value("truth_sha256", Json());
  if (truth.is_string()) row.truth = truth.get<std::string>();
  const auto digest = record::fileDigest(directory / "results.sha256");
  if (digest.isOk()) row.results = digest.value();
  return row;
}

/// Keys of the configurations that are not the same in all runs become factors.
void addConfigFactors(std::vector<RunRow*>& rows) {
  std::vector<config::Node> trees;
  trees.reserve(rows.size());
  for (const RunRow* row : rows) {
    trees.push_back(
        config::load(row->directory / "config.resolved.yaml", {}, [](const std::string&) {
          return std::nullopt;
        }).tree);
  }
  std::vector<const config::Node*> pointers;
  pointers.reserve(trees.size());
  for (const config::Node& tree : trees) pointers.push_back(&tree);
  for (const config::Difference& difference : config::differencesOf(pointers)) {
    if (difference.key == "threads" || difference.key == "name") continue;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i]->factors.push_back({difference.key, difference.values[i]});
    }
  }
}

/// Reads a table of tableOf(), with the factors between the columns name and alignment.
std::vector<RunRow> readCsv(const fs::path& file) {
  const auto lines = csvRows(must(text_encoding::readText(file)));
  const auto bad = [&](const std::string& why) {
    refuse(file, "is no table of `tolman sweep collect`: " + why);
  };
  if (lines.empty()) bad("it is empty");
  const std::vector<std::string>& names = lines.front();
  const auto factors =
      static_cast<std::size_t>(std::ranges::find(names, "alignment") - names.begin());
  if (factors < 1 || factors + 3 > names.size()) {
    bad("its first line has no alignment, truth and results after the factors");
  }
  if (lines.size() == 1) bad("it has no line after the first");
  std::vector<RunRow> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string>& fields = lines[i];
    if (fields.size() != names.size()) {
      bad(fmt::format("line {} has {} fields, the first {}", i + 1, fields.size(), names.size()));
    }
    RunRow& row = rows.emplace_back();
    row.name = fields[0];
    row.directory = file;
    for (std::size_t k = 1; k < factors; ++k) row.factors.push_back({names[k], fields[k]});
    row.alignment = fields[factors];
    row.truth = fields[factors + 1];
    row.results = fields[factors + 2];
    for (std::size_t k = factors + 3; k < fields.size(); ++k) {
      if (fields[k].empty()) continue;
      const auto number = config::readReal(fields[k]);
      if (!number.isOk()) {
        bad(fmt::format("line {}, {}: '{}' is no number", i + 1, names[k], fields[k]));
      }
      row.metrics[names[k]] = number.value();
    }
  }
  return rows;
}

/// Of a CSV table, or a sweep: runs of its last plan that are done.
std::vector<RunRow> readTable(const fs::path& path) {
  if (path.extension() == ".csv") return readCsv(path);
  std::vector<RunRow> rows;
  for (const PlannedRun& point : frozenRuns(path).planned) {
    const PointOutcome outcome = outcomeOf(path / point.folder);
    if (point.is_front_end || outcome.state != PointState::Done) continue;
    RunRow& row = rows.emplace_back(readRun(path / point.folder / "run"));
    row.name = point.name;
    row.factors = point.factors;
    row.metrics["exit_code"] = outcome.exit_code;
  }
  return rows;
}

}  // namespace

bool isTime(const std::string& metric) {
  return metric.starts_with("timing.") || metric.starts_with("finish_s.");
}

std::string unfinishedText(const fs::path& sweep) {
  if (sweep.extension() == ".csv") return "";
  FrozenRuns frozen = frozenRuns(sweep);
  std::erase_if(frozen.planned, [](const PlannedRun& point) { return point.is_front_end; });
  std::size_t failed = 0;
  std::size_t waiting = 0;
  for (const PlannedRun& point : frozen.planned) {
    const PointState state = outcomeOf(sweep / point.folder).state;
    if (state == PointState::Failed) ++failed;
    if (state != PointState::Failed && state != PointState::Done) ++waiting;
  }
  if (failed + waiting + frozen.missing.size() == 0) return "";
  const std::string missing =
      frozen.missing.empty()
          ? ""
          : fmt::format(", {} have no readable point.json", frozen.missing.size());
  return fmt::format(
      "{}: of {} runs {} failed and {} are not done{}, and are not in the table; see "
      "`tolman sweep status {}`",
      sweep.string(), frozen.planned.size() + frozen.missing.size(), failed, waiting, missing,
      sweep.string());
}

std::string RunRow::label(const std::string& factor) const {
  const auto found = std::ranges::find(factors, factor, &Factor::name);
  return found == factors.end() ? "" : found->label;
}

std::string RunRow::labelsWithout(const std::vector<std::string>& left_out) const {
  std::set<std::string> lines;  // tables may have their factors in different orders
  for (const Factor& own : factors) {
    if (std::ranges::find(left_out, own.name) == left_out.end())
      lines.insert(own.name + "=" + own.label + "\n");
  }
  std::string labels;
  for (const std::string& line : lines) labels += line;
  return labels;
}

std::vector<std::string> factorNames(const std::vector<RunRow>& rows) {
  std::vector<std::string> names;
  for (const RunRow& row : rows) {
    for (const Factor& factor : row.factors) {
      if (std::ranges::find(names, factor.name) == names.end()) names.push_back(factor.name);
    }
  }
  return names;
}

Result<std::vector<RunRow>> readRunRows(const std::vector<fs::path>& folders) {
  return resultOf([&] {
    std::vector<RunRow> rows;
    std::vector<std::size_t> alone;
    std::set<fs::path> read;
    for (const fs::path& folder : folders) {
      if (!read.insert(record::truePath(folder)).second) continue;
      std::vector<RunRow> own = readTable(folder);
      if (own.empty() && frozenRuns(folder).empty()) {
        alone.push_back(rows.size());
        rows.push_back(readRun(folder));
      }
      std::ranges::move(own, std::back_inserter(rows));
    }
    std::vector<RunRow*> others;
    std::vector<fs::path> paths;
    for (const std::size_t i : alone) {
      others.push_back(&rows[i]);
      paths.push_back(rows[i].directory);
    }
    const auto names = engine::distinctNames(paths);
    for (std::size_t i = 0; i < others.size(); ++i) {
      others[i]->name = names[i];
      others[i]->is_alone = true;
    }
    addConfigFactors(others);
    return rows;
  });
}

Table tableOf(const std::vector<RunRow>& rows, const std::vector<std::string>& wanted) {
  const std::vector<std::string> factors = factorNames(rows);
  std::set<std::string> metrics;
  for (const RunRow& row : rows) {
    for (const auto& [name, value] : row.metrics) {
      const bool is_wanted =
          wanted.empty() ? !isTime(name)
                         : std::ranges::find(wanted, name) != wanted.end() || isNeeded(name);
      if (is_wanted) metrics.insert(name);
    }
  }
  Table table;
  table.keys = {"name"};
  table.keys.insert(table.keys.end(), factors.begin(), factors.end());
  table.keys.insert(table.keys.end(), {"alignment", "truth_sha256", "results_sha256"});
  table.keys.insert(table.keys.end(), metrics.begin(), metrics.end());
  for (const RunRow& row : rows) {
    std::vector<Json>& values = table.values.emplace_back(1, row.name);
    for (const std::string& factor : factors) values.emplace_back(row.label(factor));
    for (const std::string& text : {row.alignment, row.truth, row.results}) {
      values.emplace_back(text);
    }
    for (const std::string& metric : metrics) {
      const auto value = row.metrics.find(metric);
      values.push_back(value == row.metrics.end() ? Json() : Json(value->second));
    }
  }
  return table;
}

}  // namespace tolman::experiment
