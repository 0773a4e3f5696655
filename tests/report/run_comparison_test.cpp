// SPDX-License-Identifier: BSD-3-Clause
#include "report/run_comparison.hpp"

#include <array>
#include <fstream>

#include "report/sample_pages.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::report;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t number = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++number;
  return number;
}

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

TEST_CASE("each map of the page is a picture of its own, all with the same axes") {
  const ThreeRuns runs;
  const std::string maps = comparisonMaps(runs.pages);
  CHECK(count(maps, "<svg ") == 3);
  for (const char* title : {"(a) p, map rmse", "(b) q, map rmse", "(c) r, map rmse"}) {
    CHECK(contains(maps, title));
  }
  const auto size = [&](std::size_t at) {
    return maps.substr(at, maps.find("font-family", at) - at);
  };
  const auto first = maps.find("<svg ");
  CHECK(size(first) == size(maps.find("<svg ", first + 1)));
  CHECK(comparisonMaps({runs.pages[0]}).empty());
}

TEST_CASE("the table of three runs fits a screen of 390 px, and many runs are scrolled") {
  const ThreeRuns runs;
  CHECK(contains(comparisonTable(runs.pages),
                 "<div class=\"wide\"><table class=\"comparison\" "
                 "style=\"--runs: 3\">"));
  // 6 + 3 * 4.5 rem of 16 px, where 390 px less the margins of 16 px are left
  CHECK((6 + 3 * 4.5) * 16 <= 390 - 2 * 16);
  CHECK(contains(html(runs.pages), "min-width: calc(6rem + 4.5rem * var(--runs))"));
  CHECK(contains(html(runs.pages), "repeat(auto-fit, minmax(min(100%, 21rem), 1fr))"));
}
