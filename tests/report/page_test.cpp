// SPDX-License-Identifier: BSD-3-Clause
// The page about a run.
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
  CHECK(names == std::vector<std::string>{"map", "error", "steps", "templates", "firing", "units",
                                          "timing"});
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
}

TEST_CASE("the firing figure comes with its numbers") {
  const test::TemporaryFolder folder;
  test::recordRichRun(folder.path(), 12, "sample");
  const auto page = test::pageOf(folder.path());
  REQUIRE(page.isOk());
  CHECK(page.value().neurons["head_direction"].size() == 4);
}

TEST_CASE("what is no run is one clear error") {
  const test::TemporaryFolder folder;
  const auto page = test::pageOf(folder.path());
  REQUIRE_FALSE(page.isOk());
  CHECK(contains(page.status().message(), "run.sqlite"));
}

TEST_CASE("health and errors come before the figures") {
  const test::TemporaryFolder folder;
  test::recordRichRun(folder.path(), 5, "first");
  const std::string text = html({test::pageOf(folder.path()).value()});
  CHECK(contains(text, "<title>Tolman: first</title>"));
  CHECK(contains(text, "<h1>first</h1>\n<p>" + folder.path().filename().string() + "</p>"));
  CHECK(text.find("<h2>Health</h2>") < text.find("<h2>Errors</h2>"));
  CHECK(text.find("<h2>Errors</h2>") < text.find("<figure"));
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
  const auto units = drawnUnits(data);
  REQUIRE_FALSE(units.empty());
  const auto& rates = units[0].rates;
  CHECK(rates.bin * static_cast<double>(rates.rate.cols()) > 30);

  settings.alignment = config::AlignmentChoice::Se3;
  data = readRun(*reader.value(), settings).value();
  CHECK(data.metres == 1);
  data.has_metres = false;
  CHECK(contains(mapFigure({pictureOf(data, "")}), "of the start (units)"));
}
