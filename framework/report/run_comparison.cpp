// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "config/tree.hpp"
#include "report/map_picture.hpp"
#include "report/page.hpp"
#include "report/svg.hpp"

namespace tolman::report {
namespace {

using Json = nlohmann::ordered_json;
using TextOf = std::function<std::string(const RunPage&)>;

constexpr std::size_t kMaxSettings = 12;
constexpr const char* kNone = "–";

std::string row(const std::string& label, const std::vector<std::string>& cells) {
  std::string text = "<tr><th>" + escaped(label) + "</th>";
  for (const std::string& cell : cells) text += "<td>" + escaped(cell) + "</td>";
  return text + "</tr>\n";
}

/// Rows of settings that all runs have. Parameters of plugins that only some runs use are left out,
/// because they are many.
std::string settingRows(const std::vector<RunPage>& runs) {
  std::vector<const config::Node*> trees;
  trees.reserve(runs.size());
  for (const RunPage& run : runs) trees.push_back(&run.settings);
  auto differences = config::differencesOf(trees);
  std::erase_if(differences, [](const config::Difference& difference) {
    return difference.key == "name" || difference.key == "threads" ||
           std::ranges::find(difference.values, "-") != difference.values.end();
  });
  std::string text;
  for (std::size_t i = 0; i < std::min(differences.size(), kMaxSettings); ++i) {
    text += row(differences[i].key, differences[i].values);
  }
  if (differences.size() > kMaxSettings) {
    text += fmt::format("<tr><th colspan=\"{}\">and {} more settings</th></tr>\n", runs.size() + 1,
                        differences.size() - kMaxSettings);
  }
  return text;
}

/// " (interrupted)" for a run that ended before its data, whose figures are of a part of them.
std::string earlyEnd(const RunPage& run) {
  if (run.killed) return " (killed)";
  const auto status = run.provenance.is_object() ? run.provenance.value("status", Json()) : Json();
  if (status != "interrupted" && status != "failed") return "";
  return " (" + status.get<std::string>() + ")";
}

/// A counter of run.json; a dash for a killed run.
TextOf counter(const char* name) {
  return [name](const RunPage& run) -> std::string {
    const Json* counters = run.provenance.is_object() && run.provenance.contains("counters")
                               ? &run.provenance["counters"]
                               : nullptr;
    return counters && counters->contains(name) ? (*counters)[name].dump() : kNone;
  };
}

/// A number of the scores of odometry or map; a dash without truth.
TextOf score(evaluation::TrajectoryMetrics evaluation::Metrics::*estimate, int decimals,
             std::optional<double> (*value)(const evaluation::Scores&)) {
  return [=](const RunPage& run) -> std::string {
    const auto& scores = (run.data.metrics.*estimate).scores;
    const std::optional<double> number = scores ? value(*scores) : std::nullopt;
    return number ? fmt::format("{:.{}f}", *number, decimals) : kNone;
  };
}

TextOf loops(std::int64_t evaluation::LoopFigures::*count) {
  return [count](const RunPage& run) -> std::string {
    const auto& figures = run.data.metrics.loops;
    return figures ? std::to_string(*figures.*count) : kNone;
  };
}

std::optional<double> rmse(const evaluation::Scores& scores) { return scores.ate_m.rmse; }

std::optional<double> drift(const evaluation::Scores& scores) {
  return scores.kitti.segments > 0 ? std::optional(scores.kitti.t_rel_percent) : std::nullopt;
}

std::optional<double> tracked(const evaluation::Scores& scores) { return 100 * scores.coverage; }

std::vector<std::pair<std::string, TextOf>> metricRows() {
  using evaluation::LoopFigures;
  using evaluation::Metrics;
  return {{"map ATE rmse m", score(&Metrics::map, 3, rmse)},
          {"odometry ATE rmse m", score(&Metrics::odometry, 3, rmse)},
          {"odometry t_rel %", score(&Metrics::odometry, 3, drift)},
          {"coverage %", score(&Metrics::odometry, 1, tracked)},
          {"loop links",
           [](const RunPage& run) { return std::to_string(run.data.metrics.counts.loop_links); }},
          {"true loop links", loops(&LoopFigures::true_links)},
          {"false loop links", loops(&LoopFigures::false_links)},
          {"frames", [](const RunPage& run) { return std::to_string(run.data.metrics.frames); }},
          {"lost", counter("lost")},
          {"dropped", counter("dropped")}};
}

}  // namespace

std::string comparisonTable(const std::vector<RunPage>& runs) {
  if (runs.size() < 2) return "";
  std::string text =
      "<h1>Comparison</h1>\n<div class=\"wide\"><table class=\"comparison\" style=\"--runs: " +
      std::to_string(runs.size()) + "\">\n<thead><tr><th></th>";
  for (const RunPage& run : runs) {
    text += fmt::format("<th>{}{}</th>", escaped(run.directory), earlyEnd(run));
  }
  text += "</tr></thead>\n<tbody>\n";
  for (const auto& [label, textOf] : metricRows()) {
    std::vector<std::string> cells;
    std::ranges::transform(runs, std::back_inserter(cells), textOf);
    text += row(label, cells);
  }
  const std::string settings = settingRows(runs);
  if (!settings.empty()) text += "</tbody>\n<tbody class=\"settings\">\n" + settings;
  return text + "</tbody></table></div>\n";
}

std::string comparisonMaps(const std::vector<RunPage>& runs) {
  if (runs.size() < 2) return "";
  std::string text = "<figure id=\"comparison\">\n<div class=\"maps\">\n";
  for (const std::string& svg : mapTexts(comparedMaps(runs))) text += "<div>" + svg + "</div>\n";
  return text +
         "</div><figcaption>The maps of all runs, with the same axes.</figcaption></figure>\n";
}

}  // namespace tolman::report
