// SPDX-License-Identifier: BSD-3-Clause
// The page about one run, and about several side by side.
#include "report/page.hpp"

#include <array>
#include <fstream>
#include <regex>

#include "report/figures.hpp"
#include "report/sample_pages.hpp"
#include "report/svg.hpp"
#include "support/data.hpp"

using namespace tolman::report;
using tolman::test::contains;
using namespace tolman;

namespace {

config::Node scalar(std::string key, std::string text) {
  config::Node node{config::Node::Kind::Scalar};
  node.key = std::move(key);
  node.text = std::move(text);
  return node;
}

/// Three runs of 5, 6 and 7 frames, whose counters and settings differ.
struct ThreeRuns {
  ThreeRuns() {
    for (std::size_t i = 0; i < folders.size(); ++i) {
      const auto path = folders[i].path();
      test::recordRichRun(path, static_cast<std::int64_t>(5 + i), "same");
      if (i < 2) std::ofstream(path / "run.json") << R"({"counters": {"lost": )" << i << "}}";
      RunPage page = test::pageOf(path).value();
      page.directory = std::string(1, static_cast<char>('p' + i));
      page.settings.kind = config::Node::Kind::Map;
      page.settings.children = {scalar("name", page.directory), scalar("seed", "1"),
                                scalar("speed", std::to_string(i))};
      if (i == 0) page.settings.children.push_back(scalar("only_here", "1"));
      pages.push_back(std::move(page));
    }
  }
  std::array<test::TemporaryFolder, 3> folders;
  std::vector<RunPage> pages;
};

}  // namespace

TEST_CASE("a page holds figures, errors, health, provenance and configuration of a run") {
  const test::TemporaryFolder folder;
  test::recordRichRun(folder.path(), 12, "sample");
  std::ofstream(folder.path() / "run.json")
      << R"({"seed": 7, "counters": {"frames": 12, "lost": 1}})";
  std::ofstream(folder.path() / "config.resolved.yaml") << "name: sample\n";
  const auto page = test::pageOf(folder.path());
  REQUIRE(page.isOk());
  std::vector<std::string> names;
  for (const PageFigure& figure : page.value().figures) names.push_back(figure.file);
  CHECK(names == std::vector<std::string>{"map", "error", "steps", "templates", "activity",
                                          "arrays", "firing", "units", "timing"});
  const std::string text = html({page.value()});
  CHECK(contains(text, "<title>Tolman: sample</title>"));
  CHECK(contains(text, "<td>map</td><td>11.0</td><td>0.005</td>"));
  CHECK(contains(text, "<td>lost</td><td>1</td>"));
  CHECK_FALSE(contains(text, "mean NEES"));  // its motions have no covariance
  CHECK(contains(text, "&quot;seed&quot;: 7"));
  CHECK(contains(text, "name: sample"));
}

TEST_CASE("a page has the warnings of the errors") {
  const test::TemporaryFolder folder;
  test::recordRichRun(folder.path(), 40, "feet", 3.28);
  CHECK(contains(html({test::pageOf(folder.path()).value()}), "<strong>Warning, map:</strong> "));
  const test::TemporaryFolder right;
  test::recordRichRun(right.path(), 40, "metres");
  CHECK_FALSE(contains(html({test::pageOf(right.path()).value()}), "<strong>Warning"));
}

TEST_CASE("a page needs no network, and names in it are only text") {
  const test::TemporaryFolder folder;
  test::recordRichRun(folder.path(), 3, "<script>alert(1)</script>");
  const std::string text = html({test::pageOf(folder.path()).value()});
  CHECK_FALSE(contains(text, "<script"));
  const std::regex link("(src|href|url\\()(?!=\"data:)");
  CHECK_FALSE(std::regex_search(text, link));
}

TEST_CASE("a killed run, without run.json and configuration, has a page too") {
  const test::TemporaryFolder folder;
  test::recordRichRun(folder.path(), 5, "killed");
  const std::string text = html({test::pageOf(folder.path()).value()});
  CHECK(contains(text, "<td>frames</td><td>5</td>"));
  CHECK_FALSE(contains(text, "was killed"));  // unknown without run.json
  std::ofstream(folder.path() / "run.json") << R"({"status": "running"})";
  CHECK(contains(html({test::pageOf(folder.path()).value()}), "This run was killed."));
}

TEST_CASE("several runs stand side by side, under the names of their directories") {
  const test::TemporaryFolder one;
  const test::TemporaryFolder two;
  test::recordRichRun(one.path(), 5, "first");
  test::recordRichRun(two.path(), 6, "second");
  const std::string text =
      html({test::pageOf(one.path()).value(), test::pageOf(two.path()).value()});
  const std::string a = one.path().filename().string();
  const std::string b = two.path().filename().string();
  CHECK(contains(text, "<title>Tolman: " + a + ", " + b + "</title>"));
  CHECK(contains(text, "<h1>" + a + "</h1>\n<p>first</p>"));
  CHECK(contains(text, "<h1>" + b + "</h1>\n<p>second</p>"));
  CHECK(contains(text, "(a) " + a + ", map rmse"));
  CHECK_FALSE(contains(html({test::pageOf(one.path()).value()}), "(a) "));
}

TEST_CASE("the firing figure comes with its numbers, and a unit beyond the run's is refused") {
  const test::TemporaryFolder folder;
  test::recordRichRun(folder.path(), 12, "sample");
  const auto page = test::pageOf(folder.path(), {1, 0, 1});
  REQUIRE(page.isOk());
  CHECK(page.value().neurons["head_direction"].size() == 4);
  CHECK(page.value().neurons["rate_maps"].contains("head direction unit 2 of 4, 90 deg"));
  CHECK(page.value().neurons["rate_maps"].contains("grid unit (1, 2), phase (0, 10) m"));
  const auto refused = test::pageOf(folder.path(), {4, 0, 0});
  REQUIRE_FALSE(refused.isOk());
  CHECK(refused.status().code() == StatusCode::InvalidParameter);
  CHECK(refused.status().message() ==
        folder.path().filename().string() + ": there is no head direction unit 5: this run has 4");
}

TEST_CASE("what is no run is one clear error") {
  const test::TemporaryFolder folder;
  const auto page = test::pageOf(folder.path());
  REQUIRE_FALSE(page.isOk());
  CHECK(contains(page.status().message(), "run.sqlite"));
}

TEST_CASE("health and errors come before the figures, and of several runs the comparison first") {
  const test::TemporaryFolder one;
  const test::TemporaryFolder two;
  test::recordRichRun(one.path(), 5, "first");
  test::recordRichRun(two.path(), 6, "second");
  const std::vector<RunPage> pages = {test::pageOf(one.path()).value(),
                                      test::pageOf(two.path()).value()};
  const std::string single = html({pages[0]});
  CHECK(single.find("<h2>Health</h2>") < single.find("<h2>Errors</h2>"));
  CHECK(single.find("<h2>Errors</h2>") < single.find("<figure"));
  CHECK_FALSE(contains(single, "<h1>Comparison</h1>"));
  const std::string both = html(pages);
  CHECK(both.find("<body>\n<h1>Comparison</h1>") != std::string::npos);
  CHECK(both.find("<h1>Comparison</h1>") < both.find("<figure id=\"comparison\">"));
  CHECK(both.find("<figure id=\"comparison\">") <
        both.find("<h1>" + one.path().filename().string() + "</h1>"));
}

TEST_CASE("in the dark no part of a figure stays as on paper, and none is too small to read") {
  const test::TemporaryFolder folder;
  test::recordRichRun(folder.path(), 12, "sample");
  const RunPage page = test::pageOf(folder.path()).value();
  const std::string text = html({page});
  const auto dark = text.find("@media (prefers-color-scheme: dark)");
  REQUIRE(dark != std::string::npos);
  const std::string rules = text.substr(dark, text.find("</style>") - dark);
  CHECK(contains(rules, "figure svg text { fill:"));
  const std::regex grey("(fill|stroke)=\"(white|black|#([0-9a-f]{2})\\3\\3)\"");
  for (const PageFigure& figure : page.figures) {
    const std::sregex_iterator end;
    for (std::sregex_iterator at(figure.svg.begin(), figure.svg.end(), grey); at != end; ++at) {
      if ((*at)[2] == kGrey) continue;  // legible on both
      INFO(figure.file << ": " << at->str());
      CHECK(contains(rules, "[" + at->str() + "]"));
    }
    const std::string width = figure.svg.substr(figure.svg.find("width=\"") + 7);
    INFO(figure.file);
    CHECK(contains(text, "<figure id=\"" + figure.file +
                             "\">\n<div class=\"drawing\" style=\"--width: " +
                             width.substr(0, width.find('"')) + "px\">"));
  }
}

TEST_CASE("where the scale is free all paths are drawn in metres of the truth") {
  const test::TemporaryFolder folder;
  test::recordRichRun(folder.path(), 12, "sample", 3);
  const auto reader = record::RunReader::open(folder.path());
  REQUIRE(reader.isOk());
  config::EvaluationSettings settings;
  settings.alignment = config::AlignmentChoice::Sim3;
  RunData data = readRun(*reader.value(), settings).value();
  CHECK(data.metres == Approx(3).epsilon(0.01));
  const MapPicture picture = pictureOf(data, "");
  CHECK(picture.unit == "m");
  const auto length = [](const evaluation::Trajectory& path) {
    return evaluation::pathLength(path);
  };
  CHECK(length(picture.truth) == Approx(33.03).margin(0.01));  // as recorded, whatever the scale
  CHECK(length(picture.map) == Approx(33).epsilon(0.01));
  CHECK(length(picture.odometry) == Approx(33).epsilon(0.01));
  const auto units = drawnUnits(data, {}).value();
  REQUIRE_FALSE(units.empty());
  const auto& rates = units[0].rates;
  CHECK(rates.bin * static_cast<double>(rates.rate.cols()) > 30);

  settings.alignment = config::AlignmentChoice::Se3;
  data = readRun(*reader.value(), settings).value();
  CHECK(data.metres == 1);
  data.has_metres = false;
  CHECK(contains(mapFigure({pictureOf(data, "")}), "of the start (units)"));
}

TEST_CASE("the table has a column for each run, its metrics and the settings that differ") {
  const ThreeRuns runs;
  const std::string table = comparisonTable(runs.pages);
  CHECK(contains(table, "<thead><tr><th></th><th>p</th><th>q</th><th>r</th></tr></thead>"));
  CHECK(contains(table, "<tr><th>frames</th><td>5</td><td>6</td><td>7</td></tr>"));
  CHECK(contains(table, "<tr><th>lost</th><td>0</td><td>1</td><td>–</td></tr>"));
  CHECK(contains(table, "<tr><th>map ATE rmse m</th><td>0.00"));
  CHECK(contains(table, "<tr><th>speed</th><td>0</td><td>1</td><td>2</td></tr>"));
  for (const char* equal : {">seed<", ">name<", ">only_here<"}) CHECK_FALSE(contains(table, equal));
  CHECK(comparisonTable({runs.pages[0]}).empty());
}

TEST_CASE("a run that ended before its data says so") {
  ThreeRuns runs;
  runs.pages[0].provenance["status"] = "interrupted";
  runs.pages[1].provenance["status"] = "finished";
  runs.pages[2].provenance["status"] = "failed";
  CHECK(contains(comparisonTable(runs.pages),
                 "<th>p (interrupted)</th><th>q</th><th>r (failed)</th>"));
}

TEST_CASE("more settings than a table can show are counted") {
  ThreeRuns runs;
  for (std::size_t i = 0; i < runs.pages.size(); ++i) {
    for (int k = 0; k < 20; ++k) {
      runs.pages[i].settings.children.push_back(scalar("k" + std::to_string(k), std::to_string(i)));
    }
  }
  CHECK(contains(comparisonTable(runs.pages), ">and 9 more settings<"));
}

TEST_CASE("the maps of several runs are one figure; one run has none") {
  const ThreeRuns runs;
  const std::string maps = comparisonFigure(runs.pages);
  for (const char* title : {"(a) p, map rmse", "(b) q, map rmse", "(c) r, map rmse"}) {
    CHECK(contains(maps, title));
  }
  CHECK(contains(html(runs.pages), maps));
  CHECK(comparisonFigure({runs.pages[0]}).empty());
}

TEST_CASE("the table of three runs fits a screen of 390 px, and many runs are scrolled") {
  const ThreeRuns runs;
  CHECK(contains(comparisonTable(runs.pages),
                 "<div class=\"wide\"><table class=\"comparison\" "
                 "style=\"--runs: 3\">"));
  // 6 + 3 * 4.5 rem of 16 px, where 390 px less the margins of 16 px are left
  CHECK((6 + 3 * 4.5) * 16 <= 390 - 2 * 16);
  CHECK(contains(html(runs.pages), "min-width: calc(6rem + 4.5rem * var(--runs))"));
}
