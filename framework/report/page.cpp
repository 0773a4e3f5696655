// SPDX-License-Identifier: BSD-3-Clause
#include "report/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>

#include "record/run_directory.hpp"
#include "report/figures.hpp"
#include "report/map_picture.hpp"
#include "report/svg.hpp"
#include "report/units.hpp"

namespace tolman::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --line: #8884; --soft: #777; }
body { font: 15px/1.45 system-ui, sans-serif; margin: 0 auto; padding: 1rem; max-width: 1900px; }
h1 { font-size: 1.5rem; margin: .5rem 0; } h2 { font-size: 1.1rem; margin: 1.5rem 0 .5rem; }
.runs { display: grid; gap: 1.5rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 36rem), 1fr)); }
section { min-width: 0; overflow-wrap: anywhere; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; overflow-wrap: normal; }
th, td { padding: .25rem .8rem .25rem 0; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
.counts tbody { display: grid; grid-template-columns: repeat(auto-fill, minmax(12.5rem, 1fr)); column-gap: 2rem; }
.counts, .counts tr { display: block; } .counts tr { display: flex; justify-content: space-between; border-bottom: 1px solid var(--line); }
.counts td { border: 0; padding-right: 0; }
.comparison { table-layout: fixed; width: min(100%, calc(13rem + 11rem * var(--runs))); min-width: calc(6rem + 4.5rem * var(--runs)); }
.comparison thead th:first-child { width: max(6rem, 20%); }
.comparison th, .comparison td { white-space: normal; overflow-wrap: anywhere; padding-right: .5rem; vertical-align: top; }
.comparison thead th { text-align: right; } .comparison tbody th { font-weight: normal; } .settings { border-top: 2px solid var(--line); font-size: .85rem; }
figure { margin: 1rem 0; } .drawing { overflow-x: auto; }
.drawing svg { display: block; width: 100%; min-width: calc(.85 * var(--width)); height: auto; border-radius: 4px; }
@media (min-width: 1000px) { .drawing svg { min-width: calc(.66 * var(--width)); } }
#map svg { max-height: 95vh; }
figcaption { color: var(--soft); font-size: .9rem; }
pre { overflow: auto; padding: .8rem; border: 1px solid var(--line); border-radius: 4px; font-size: .8rem; }
.wide { overflow-x: auto; }
)";

/// The style of the page, with other colours of the figures for dark mode. Figures are drawn for
/// white paper, because they are also files.
std::string style() {
  std::string dark = ":root { --soft: #9aa0a8; }\nfigure svg text { fill: #d8dade; }\n";
  const auto replace = [&](const char* light, const char* colour) {
    for (const char* attribute : {"fill", "stroke"}) {
      dark += fmt::format("figure svg [{0}=\"{1}\"] {{ {0}: {2}; }}\n", attribute, light, colour);
    }
  };
  replace(kPaper, "#17191d");
  replace(kFrameLine, "#9a9fa8");
  replace(kGridLine, "#2d3137");
  replace(kFaintLine, "#50555e");
  replace(kPaleBlue, "#1d3d54");
  replace(kBlue, "#56b4e9");  // the lighter blue of the same palette
  return kStyle + ("@media (prefers-color-scheme: dark) {\n" + dark + "}\n");
}

std::string textOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void addFigure(RunPage& page, const char* file, std::string caption, std::string svg) {
  if (!svg.empty()) page.figures.push_back({file, std::move(caption), std::move(svg)});
}

/// Adds the firing of single units, as pictures and as numbers.
Status addNeurons(RunPage& page, const UnitChoice& choice) {
  const auto units = drawnUnits(page.data, choice);
  if (!units.isOk()) {
    return {units.status().code(), page.directory + ": " + units.status().message()};
  }
  addFigure(page, "firing", "Firing rate of single units along the path.",
            firingFigure(units.value()));
  addFigure(
      page, "units",
      "All units: tuning curves, each relative to its peak, with the mean vector in red; rate "
      "maps of grid units at their places in the module.",
      unitsFigure(page.data));
  page.neurons = neuronsJson(page.data, units.value());
  return Status::ok();
}

Status addFigures(RunPage& page, const record::RunReader& reader, const UnitChoice& units) {
  const RunData& data = page.data;
  addFigure(page, "map", "Experience map over odometry and truth, seen from above.",
            mapFigure({pictureOf(data, data.name)}));
  addFigure(page, "error", "Distance to the truth at each frame.", errorFigure(data));
  addFigure(page, "steps",
            "Lengths and turns of short stretches against the true ones: jumps, standstills and "
            "changes of units stand out.",
            stepFigure(data));
  addFigure(page, "elevation",
            "Height over the first camera, against its own vertical axis, along the path.",
            elevationFigure(data));
  const auto places = reader.records<PlaceObservation>();
  if (!places.isOk()) return places.status();
  addFigure(page, "templates",
            "New local view templates along the upper bound; familiar ones below it are places "
            "seen again.",
            templateFigure(places.value()));
  const auto decisions = reader.records<Decision>();
  if (!decisions.isOk()) return decisions.status();
  addFigure(
      page, "activity",
      "State of the attractor networks at four moments; the red line is the estimated heading.",
      activityFigure(data.cells, decisions.value()));
  addFigure(page, "arrays", "Other arrays of the cells over time; at most 40 are drawn.",
            arrayFigure(data.cells.others));
  const Status neurons = addNeurons(page, units);
  if (!neurons.isOk()) return neurons;
  addFigure(page, "timing", "Time that each stage took for a frame, ms.",
            timingFigure(data.metrics));
  return Status::ok();
}

/// A figure as wide as the page. On a page narrower than the figure it is scrolled, not shrunk.
std::string figureText(std::string_view id, const std::string& svg, std::string_view caption) {
  constexpr std::string_view kWidth = " width=\"";
  const std::string width = svg.substr(svg.find(kWidth) + kWidth.size());
  return fmt::format(
      "<figure id=\"{}\">\n<div class=\"drawing\" style=\"--width: {}px\">\n{}</div>"
      "<figcaption>{}</figcaption></figure>\n",
      id, width.substr(0, width.find('"')), svg, escaped(caption));
}

constexpr const char* kNone = "–";

std::optional<double> rmseOf(const evaluation::Statistics& errors) {
  return errors.count > 0 ? std::optional(errors.rmse) : std::nullopt;
}

std::optional<double> drift(const evaluation::Scores& scores, double value) {
  return scores.kitti.segments > 0 ? std::optional(value) : std::nullopt;
}

/// A figure of the errors: its heading, and its text for a trajectory; a dash where it is not
/// known.
struct ErrorColumn {
  const char* heading;
  std::optional<double> (*value)(const evaluation::Scores&);
  int decimals = 3;

  std::string text(const evaluation::TrajectoryMetrics& of) const {
    const auto number = of.scores ? value(*of.scores) : std::nullopt;
    return number ? fmt::format("{:.{}f}", *number, decimals) : kNone;
  }
};

using evaluation::Scores;
constexpr std::array<ErrorColumn, 9> kErrorColumns = {{
    {"<th>ATE rmse m</th>", [](const Scores& s) { return std::optional(s.ate_m.rmse); }},
    {"<th>mean</th>", [](const Scores& s) { return std::optional(s.ate_m.mean); }},
    {"<th>median</th>", [](const Scores& s) { return std::optional(s.ate_m.median); }},
    {"<th>max</th>", [](const Scores& s) { return std::optional(s.ate_m.max); }},
    {"<th>horizontal rmse m</th>", [](const Scores& s) { return rmseOf(s.horizontal_m); }},
    {"<th>vertical rmse m</th>", [](const Scores& s) { return rmseOf(s.vertical_m); }},
    {"<th title=\"KITTI drift: mean translation error of sub-paths\">t_rel %</th>",
     [](const Scores& s) { return drift(s, s.kitti.t_rel_percent); }},
    {"<th title=\"KITTI drift: mean rotation error of sub-paths\">r_rel °/100 m</th>",
     [](const Scores& s) { return drift(s, s.kitti.r_rel_deg_per_100m); }},
    {"<th title=\"share of the true poses that have a tracked estimate\">coverage %</th>",
     [](const Scores& s) { return std::optional(100 * s.coverage); }, 1},
}};

std::string errorRow(const char* name, const evaluation::TrajectoryMetrics& m) {
  std::string row = fmt::format("<tr><td>{}</td><td>{:.1f}{}</td>", name, m.path_length_m,
                                m.in_metres ? "" : " units");
  for (const ErrorColumn& column : kErrorColumns) row += "<td>" + column.text(m) + "</td>";
  return row + "</tr>\n";
}

/// Warnings, and why the columns of horizontal and vertical error are empty.
std::string errorNotes(const evaluation::Metrics& metrics) {
  std::string warnings;
  std::string open_turn;
  for (const auto& [name, trajectory] :
       {std::pair("odometry", &metrics.odometry), std::pair("map", &metrics.map)}) {
    const auto& scores = trajectory->scores;
    if (!trajectory->warning.empty()) {
      warnings += fmt::format("<p><strong>Warning, {}:</strong> {}</p>\n", name,
                              escaped(trajectory->warning));
    }
    if (scores && !scores->no_horizontal.empty() && open_turn.empty()) {
      open_turn = "<p>Horizontal and vertical error: " + escaped(scores->no_horizontal) + ".</p>\n";
    }
  }
  return warnings + open_turn;
}

std::string errorTable(const evaluation::Metrics& metrics) {
  std::string text =
      fmt::format("<div class=\"wide\"><table><tr><th>after {} alignment</th><th>path m</th>",
                  evaluation::alignmentText(metrics));
  for (const ErrorColumn& column : kErrorColumns) text += column.heading;
  return text + "</tr>\n" + errorRow("odometry", metrics.odometry) + errorRow("map", metrics.map) +
         "</table></div>\n" + errorNotes(metrics);
}

/// Table of the sessions; empty for a single session whose map is connected.
std::string sessionTable(const evaluation::Metrics& metrics) {
  if (metrics.sessions.size() < 2 && metrics.parts < 2) return "";
  std::string text =
      "<h2>Sessions</h2>\n<table><tr><th>session</th><th>name</th><th>first frame"
      "</th><th>frames</th><th>experiences</th><th>parts of the map</th></tr>\n";
  for (std::size_t i = 0; i < metrics.sessions.size(); ++i) {
    const evaluation::SessionFigures& s = metrics.sessions[i];
    text += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", i,
        escaped(s.name), s.first_frame, s.frames, s.experiences, fmt::join(s.parts, ", "));
  }
  text += "</table>\n";
  const std::string unjoined = evaluation::unjoinedText(metrics);
  return text + "<p>" +
         (unjoined.empty() ? "All parts of the map are connected." : escaped(unjoined)) + "</p>\n";
}

/// Rows with the latency of a realtime run.
std::string latencyRows(const Json& provenance) {
  if (!provenance.is_object()) return "";
  const auto latency = provenance.find("latency");
  if (latency == provenance.end() || !latency->is_object()) return "";
  const auto value = [&](const char* key) {
    const auto found = latency->find(key);
    return found != latency->end() && found->is_number() ? found->get<double>() : 0.0;
  };
  return fmt::format(
      "<tr><td title=\"from the exposure of a frame to its pose in the map\">latency, median</td>"
      "<td>{:.1f} ms</td></tr><tr><td>latency, 99 %</td><td>{:.1f} ms</td></tr>\n",
      value("median_ms"), value("p99_ms"));
}

/// The verdicts, and the list of loops and near misses.
std::string verdictList(const evaluation::Metrics& metrics) {
  std::string text = "<ul>\n";
  for (const std::string& verdict : evaluation::verdictsOf(metrics)) {
    text += "<li>" + escaped(verdict) + "</li>\n";
  }
  return text + "</ul>\n";
}

std::string loopTable(const std::vector<LoopStory>& loops) {
  constexpr std::size_t kMost = 60;
  if (loops.empty()) return "";
  std::string text = "<h2>Loops</h2>\n<div class=\"wide\"><table><tr>";
  for (const std::string& heading : storyHeadings()) text += "<th>" + heading + "</th>";
  text += "</tr>\n";
  for (std::size_t i = 0; i < std::min(kMost, loops.size()); ++i) {
    text += "<tr title=\"" + escaped(loops[i].text()) + "\">";
    for (const std::string& cell : loops[i].cells()) text += "<td>" + escaped(cell) + "</td>";
    text += "</tr>\n";
  }
  text += "</table></div>\n<p>";
  if (loops.size() > kMost) text += fmt::format("{} more. ", loops.size() - kMost);
  return text +
         "<code>tolman explain RUN --frame N</code> explains one of them, with both views.</p>\n";
}

/// The words for a counter of run.json.
std::string labelOf(const std::string& counter) {
  constexpr std::array<std::pair<const char*, const char*>, 5> kWords = {
      {{"impossible", "impossible motions"},
       {"defects", "images missing or faulty"},
       {"nearly_black", "nearly black images"},
       {"unmoved", "frames with zero motion"},
       {"place_left_out", "frames without place recognition"}}};
  for (const auto& [name, words] : kWords) {
    if (counter == name) return words;
  }
  std::string words = counter;
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string healthTable(const Json& provenance, const evaluation::Metrics& metrics) {
  std::string rows;
  const auto counters = provenance.find("counters");
  if (provenance.is_object() && counters != provenance.end()) {
    for (const auto& [key, value] : counters->items()) {
      rows += fmt::format(
          "<tr><td>{}</td><td>{}</td></tr>\n", escaped(labelOf(key)),
          escaped(value.is_boolean() ? (value.get<bool>() ? "yes" : "no") : value.dump()));
    }
  } else {  // a killed run has no counters in run.json
    rows =
        fmt::format("<tr><td>frames</td><td>{}</td></tr><tr><td>loop links</td><td>{}</td></tr>\n",
                    metrics.frames, metrics.counts.loop_links);
  }
  if (const auto& motions = metrics.motions; motions.motions > motions.without_covariance) {
    rows += fmt::format(
        "<tr><td title=\"motions whose error lies within the 99 % ellipsoid of their covariance\">"
        "motions within 99 %</td><td>{:.1f} %</td></tr><tr><td title=\"normalised error squared of "
        "the motions; {} for honest covariances\">mean NEES</td><td>{:.2f}</td></tr>\n",
        100 * motions.share_99, motions.degrees_of_freedom, motions.mean);
  }
  rows += latencyRows(provenance);
  return "<table class=\"counts\">" + rows + "</table>\n";
}

/// The line below the heading of a run: its other name, and its plugins.
std::string subtitle(const RunPage& run, const std::string& other) {
  std::string text = other;
  const auto plugins = run.provenance.find("plugins");
  if (!run.provenance.is_object() || plugins == run.provenance.end()) return text;
  for (const Json& plugin : *plugins) {
    if (plugin.is_object()) {
      text += " · " + plugin.value("stage", "?") + ": " + plugin.value("id", "?");
    }
  }
  return text;
}

std::string section(const RunPage& run, const std::string& name) {
  const std::string& other = name == run.directory ? run.data.name : run.directory;
  std::string text = fmt::format("<section>\n<h1>{}</h1>\n<p>{}</p>\n", escaped(name),
                                 escaped(subtitle(run, other)));
  if (run.killed) {
    text +=
        "<p><strong>This run was killed.</strong> The page shows what it had recorded; counters "
        "and warnings of its end are missing.</p>\n";
  }
  text += verdictList(run.data.metrics);
  text += "<h2>Health</h2>\n" + healthTable(run.provenance, run.data.metrics);
  text += "<h2>Errors</h2>\n" + errorTable(run.data.metrics);
  text += loopTable(run.data.loops);
  text += sessionTable(run.data.metrics);
  for (const PageFigure& figure : run.figures) {
    text += figureText(figure.file, figure.svg, figure.caption);
  }
  text += "<h2>Provenance</h2>\n<details><summary>run.json</summary><pre>" +
          escaped(run.provenance.dump(2)) + "</pre></details>\n";
  text += "<details><summary>config.resolved.yaml</summary><pre>" + escaped(run.config) +
          "</pre></details>\n</section>\n";
  return text;
}

using TextOf = std::function<std::string(const RunPage&)>;

constexpr std::size_t kMaxSettings = 12;

std::string rowOf(const std::string& label, const std::vector<std::string>& cells) {
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
    text += rowOf(differences[i].key, differences[i].values);
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

TextOf score(evaluation::TrajectoryMetrics evaluation::Metrics::*estimate,
             const ErrorColumn& column) {
  return [=](const RunPage& run) { return column.text(run.data.metrics.*estimate); };
}

TextOf loops(std::int64_t evaluation::LoopFigures::*count) {
  return [count](const RunPage& run) -> std::string {
    const auto& figures = run.data.metrics.loops;
    return figures ? std::to_string(*figures.*count) : kNone;
  };
}

std::vector<std::pair<std::string, TextOf>> metricRows() {
  using evaluation::LoopFigures;
  using evaluation::Metrics;
  return {
      {"alignment", [](const RunPage& run) { return evaluation::alignmentText(run.data.metrics); }},
      {"map ATE rmse m", score(&Metrics::map, kErrorColumns[0])},
      {"odometry ATE rmse m", score(&Metrics::odometry, kErrorColumns[0])},
      {"odometry t_rel %", score(&Metrics::odometry, kErrorColumns[6])},
      {"coverage %", score(&Metrics::odometry, kErrorColumns[8])},
      {"loop links",
       [](const RunPage& run) { return std::to_string(run.data.metrics.counts.loop_links); }},
      {"true loop links", loops(&LoopFigures::true_links)},
      {"false loop links", loops(&LoopFigures::false_links)},
      {"frames", [](const RunPage& run) { return std::to_string(run.data.metrics.frames); }},
      {"lost", counter("lost")},
      {"dropped", counter("dropped")}};
}

}  // namespace

Result<RunPage> makePage(const record::RunReader& reader, RunData data, const UnitChoice& units) {
  const std::filesystem::path& directory = reader.directory();
  RunPage page{std::move(data),
               directory.filename().string(),
               {},
               nullptr,
               record::RunDirectory::readRunFile(directory),
               textOf(directory / "config.resolved.yaml"),
               record::RunDirectory::wasKilled(directory)};
  const Status drawn = addFigures(page, reader, units);
  if (!drawn.isOk()) return drawn;
  page.data.cells = {};  // large, and drawn already
  return page;
}

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
    text += rowOf(label, cells);
  }
  const std::string settings = settingRows(runs);
  if (!settings.empty()) text += "</tbody>\n<tbody class=\"settings\">\n" + settings;
  return text + "</tbody></table></div>\n";
}

std::string comparisonFigure(const std::vector<RunPage>& runs) {
  if (runs.size() < 2) return "";
  std::vector<MapPicture> pictures;
  for (const RunPage& run : runs) {
    const auto& scores = run.data.metrics.map.scores;
    const std::string error = scores ? fmt::format(", map rmse {:.2f} m", scores->ate_m.rmse) : "";
    pictures.push_back(pictureOf(run.data, run.directory + error));
  }
  return mapFigure(pictures);
}

std::string html(const std::vector<RunPage>& runs) {
  std::string title;
  std::string body = comparisonTable(runs);
  if (const std::string maps = comparisonFigure(runs); !maps.empty()) {
    body += figureText("comparison", maps, "The maps of all runs, with the same axes.");
  }
  body += "<main class=\"runs\">\n";
  for (const RunPage& run : runs) {
    const std::string& name = runs.size() > 1 ? run.directory : run.data.name;
    title += (title.empty() ? "" : ", ") + name;
    body += section(run, name);
  }
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>Tolman: {}</title>\n<style>{}</style>\n</head>\n<body>\n{}"
      "</main>\n</body>\n</html>\n",
      escaped(title), style(), body);
}

}  // namespace tolman::report
