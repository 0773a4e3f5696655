// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text_file.hpp"
#include "record/run_directory.hpp"
#include "report/figures.hpp"
#include "report/svg.hpp"

namespace tolman::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kStyle = R"(
:root { color-scheme: light; --line: #8884; --soft: #777; }
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
figure { margin: 1rem 0; } .drawing { overflow-x: auto; }
.drawing svg { display: block; width: 100%; min-width: calc(.85 * var(--width)); height: auto; border-radius: 4px; }
@media (min-width: 1000px) { .drawing svg { min-width: calc(.66 * var(--width)); } }
#map svg { max-height: 95vh; }
figcaption { color: var(--soft); font-size: .9rem; }
pre { overflow: auto; padding: .8rem; border: 1px solid var(--line); border-radius: 4px; font-size: .8rem; }
.wide { overflow-x: auto; }
)";

/// All figures for which the run has data.
std::vector<PageFigure> figuresOf(const RunData& data) {
  std::vector<PageFigure> figures = {
      {"map", "Experience map over odometry and truth, seen from above.",
       mapFigure(pictureOf(data, data.name))},
      {"error", "Distance to the truth at each frame.", errorFigure(data)},
      {"steps",
       "Lengths and turns of short stretches against the true ones: jumps, standstills and "
       "changes of units stand out.",
       stepFigure(data)},
      {"templates",
       "New local view templates along the upper bound; familiar ones below it are places seen "
       "again.",
       templateFigure(data.record.places)},
      {"firing", "Firing rate of single units along the path.", firingFigure(drawnUnits(data))},
      {"units",
       "All units: tuning curves, each relative to its peak, with the mean vector in red; rate "
       "maps of grid units at their places in the module.",
       unitsFigure(data)},
      {"timing", "Time that each stage took for a frame, ms.", timingFigure(data.metrics)}};
  std::erase_if(figures, [](const PageFigure& figure) { return figure.svg.empty(); });
  return figures;
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

/// A row of a table. `first`: tag of its first cell, `rest`: of the others.
std::string rowOf(const std::vector<std::string>& cells, const char* first = "td",
                  const char* rest = "td", const std::string& title = "") {
  std::string text = title.empty() ? "<tr>" : "<tr title=\"" + escaped(title) + "\">";
  for (const std::string& cell : cells) {
    const char* tag = &cell == &cells.front() ? first : rest;
    text += fmt::format("<{0}>{1}</{0}>", tag, escaped(cell));
  }
  return text + "</tr>\n";
}

/// The figures of a row of errors; a dash where one is not known.
std::vector<std::string> errorCells(const char* name, const evaluation::TrajectoryMetrics& of) {
  std::vector<std::string> cells = {
      name, fmt::format("{:.1f}{}", of.path_length_m, of.in_metres ? "" : " units")};
  const evaluation::Scores s = of.scores.value_or(evaluation::Scores{});
  const auto add = [&](bool known, double value, int decimals = 3) {
    cells.push_back(of.scores && known ? fmt::format("{:.{}f}", value, decimals) : kNone);
  };
  for (const double value : {s.ate_m.rmse, s.ate_m.mean, s.ate_m.median, s.ate_m.max}) {
    add(true, value);
  }
  add(s.horizontal_m.count > 0, s.horizontal_m.rmse);
  add(s.vertical_m.count > 0, s.vertical_m.rmse);
  add(s.kitti.segments > 0, s.kitti.t_rel_percent);
  add(s.kitti.segments > 0, s.kitti.r_rel_deg_per_100m);
  add(true, 100 * s.coverage, 1);
  return cells;
}

/// The errors; warnings, and why the columns of horizontal and vertical error are empty.
std::string errorTable(const evaluation::Metrics& metrics) {
  const std::vector<std::string> heading = {
      fmt::format("after {} alignment", evaluation::alignmentText(metrics)),
      "path m",
      "ATE rmse m",
      "mean",
      "median",
      "max",
      "horizontal rmse m",
      "vertical rmse m",
      "t_rel %",
      "r_rel °/100 m",
      "coverage %"};
  std::string rows, warnings, open_turn;
  for (const auto& [name, of] :
       {std::pair("odometry", &metrics.odometry), std::pair("map", &metrics.map)}) {
    rows += rowOf(errorCells(name, *of));
    if (!of->warning.empty()) {
      warnings +=
          fmt::format("<p><strong>Warning, {}:</strong> {}</p>\n", name, escaped(of->warning));
    }
    if (of->scores && !of->scores->no_horizontal.empty() && open_turn.empty()) {
      open_turn =
          "<p>Horizontal and vertical error: " + escaped(of->scores->no_horizontal) + ".</p>\n";
    }
  }
  return "<div class=\"wide\"><table>" + rowOf(heading, "th", "th") + rows + "</table></div>\n" +
         warnings + open_turn;
}

/// Table of the sessions; empty for a single session whose map is connected.
std::string sessionTable(const evaluation::Metrics& metrics) {
  if (metrics.sessions.size() < 2 && metrics.parts < 2) return "";
  std::string rows = rowOf(
      {"session", "name", "first frame", "frames", "experiences", "parts of the map"}, "th", "th");
  for (const evaluation::SessionFigures& s : metrics.sessions) {
    rows += rowOf({fmt::format("{}", &s - metrics.sessions.data()), s.name,
                   fmt::format("{}", s.first_frame), fmt::format("{}", s.frames),
                   fmt::format("{}", s.experiences), fmt::format("{}", fmt::join(s.parts, ", "))});
  }
  const std::string unjoined = evaluation::unjoinedText(metrics);
  return "<h2>Sessions</h2>\n<table>" + rows + "</table>\n<p>" +
         (unjoined.empty() ? "All parts of the map are connected." : escaped(unjoined)) + "</p>\n";
}

/// What run.json holds at these keys; null where it is missing.
Json at(const Json& provenance, const char* key, const char* inner = nullptr) {
  const auto found = provenance.is_object() ? provenance.find(key) : provenance.end();
  if (!provenance.is_object() || found == provenance.end()) return {};
  return inner == nullptr ? *found : at(*found, inner);
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
  std::string text =
      "<h2>Loops</h2>\n<div class=\"wide\"><table>" + rowOf(storyHeadings(), "th", "th");
  for (std::size_t i = 0; i < std::min(kMost, loops.size()); ++i) {
    text += rowOf(loops[i].cells(), "td", "td", loops[i].text());
  }
  text += "</table></div>\n<p>";
  if (loops.size() > kMost) text += fmt::format("{} more. ", loops.size() - kMost);
  return text +
         "<code>tolman explain RUN --frame N</code> explains one of them, with both views.</p>\n";
}

/// The words for a counter of run.json.
std::string labelOf(const std::string& counter) {
  constexpr std::array<std::pair<const char*, const char*>, 4> kWords = {
      {{"impossible", "impossible motions"},
       {"defects", "images missing or faulty"},
       {"nearly_black", "nearly black images"},
       {"unmoved", "frames with zero motion"}}};
  for (const auto& [name, words] : kWords) {
    if (counter == name) return words;
  }
  std::string words = counter;
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string healthTable(const Json& provenance, const evaluation::Metrics& metrics) {
  std::string rows;
  const Json counters = at(provenance, "counters");
  for (const auto& [key, value] : counters.items()) {
    rows += rowOf(
        {labelOf(key), value.is_boolean() ? (value.get<bool>() ? "yes" : "no") : value.dump()});
  }
  if (counters.is_null()) {  // of a killed run
    rows = rowOf({"frames", std::to_string(metrics.frames)}) +
           rowOf({"loop links", std::to_string(metrics.counts.loop_links)});
  }
  if (const auto& motions = metrics.motions; motions.motions > motions.without_covariance) {
    rows += rowOf({"motions within 99 %", fmt::format("{:.1f} %", 100 * motions.share_99)}, "td",
                  "td", "motions whose error lies within the 99 % ellipsoid of their covariance") +
            rowOf({"mean NEES", fmt::format("{:.2f}", motions.mean)}, "td", "td",
                  fmt::format("normalised error squared of the motions; {} for honest covariances",
                              motions.degrees_of_freedom));
  }
  for (const auto& [label, key] :
       {std::pair("latency, median", "median_ms"), {"latency, 99 %", "p99_ms"}}) {
    const Json ms = at(provenance, "latency", key);
    if (!ms.is_number()) continue;
    rows += rowOf({label, fmt::format("{:.1f} ms", ms.get<double>())}, "td", "td",
                  "from the exposure of a frame to its pose in the map");
  }
  return "<table class=\"counts\">" + rows + "</table>\n";
}

/// The line below the heading of a run: its other name, and its plugins.
std::string subtitle(const RunPage& run, const std::string& other) {
  std::string text = other;
  for (const Json& plugin : at(run.provenance, "plugins")) {
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

}  // namespace

RunPage makePage(const std::filesystem::path& directory, RunData data) {
  const auto config = text_encoding::readText(directory / "config.resolved.yaml");
  RunPage page{{},
               directory.filename().string(),
               figuresOf(data),
               neuronsJson(data),
               record::RunDirectory::readRunFile(directory),
               config.isOk() ? config.value() : "",
               record::RunDirectory::wasKilled(directory)};
  page.data = std::move(data);
  page.data.cells = {};  // large, and drawn already
  page.data.record = {};
  return page;
}

std::string html(const std::vector<RunPage>& runs) {
  std::string title, sections;
  for (const RunPage& run : runs) {
    const std::string& name = runs.size() > 1 ? run.directory : run.data.name;
    title += (title.empty() ? "" : ", ") + name;
    sections += section(run, name);
  }
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>Tolman: {}</title>\n<style>{}</style>\n</head>\n<body>\n<main class=\"runs\">\n{}"
      "</main>\n</body>\n</html>\n",
      escaped(title), kStyle, sections);
}

}  // namespace tolman::report
