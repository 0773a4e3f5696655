// SPDX-License-Identifier: BSD-3-Clause
// Measures the tables of views in docs/camera-maps.md again: precision and recall of
// `view_templates` on a corridor that was walked twice, at each threshold of the page.
#include <spdlog/fmt/fmt.h>

#include <catch2/catch.hpp>
#include <sstream>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

using Cells = std::vector<std::string>;

/// Cells of a row of a Markdown table, without the first, which names the row.
Cells cellsOf(const std::string& row) {
  Cells cells;
  std::istringstream stream(row.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const auto from = cell.find_first_not_of(' ');
    if (from == std::string::npos) continue;
    cells.push_back(cell.substr(from, cell.find_last_not_of(' ') + 1 - from));
  }
  cells.erase(cells.begin());
  return cells;
}

struct Table {
  Cells thresholds, precision, recall;
};

/// The table whose head begins with `| HEAD: threshold |`.
Table tableOf(const std::string& page, const std::string& head) {
  const auto at = page.find("| " + head + ": threshold |");
  REQUIRE(at != std::string::npos);
  std::istringstream lines(page.substr(at));
  std::string thresholds, rule, precision, recall;
  std::getline(lines, thresholds);
  std::getline(lines, rule);
  std::getline(lines, precision);
  std::getline(lines, recall);
  return {cellsOf(thresholds), cellsOf(precision), cellsOf(recall)};
}

/// Precision and recall of all claims at one threshold, with two decimals as on the page.
std::pair<std::string, std::string> measured(const fs::path& data, const Cells& settings) {
  Cells command = {"bench",   "places",
                   "--json",  inSource("configs/places/openratslam.yaml"),
                   "--pairs", (data / "true_pairs.csv").string(),
                   "--set",   "source.path=" + (data / "images").string()};
  for (const std::string& setting : settings) command.insert(command.end(), {"--set", setting});
  const Finished finished = tolman::test::tolman(command);
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const auto curve = nlohmann::json::parse(finished.out)["curve"];
  REQUIRE_FALSE(curve.empty());
  return {fmt::format("{:.2f}", curve.back()["precision"].get<double>()),
          fmt::format("{:.2f}", curve.back()["recall"].get<double>())};
}

}  // namespace

TEST_CASE("views: the page's precision and recall are those of the plugin", "[data]") {
  const auto data = dataOrSkip("places_two_laps");
  if (!data) return;
  const auto& [head, settings] = GENERATE(table<std::string, Cells>(
      {{"grey, 60x10", {}},
       {"grey in patches, 32x24",
        {"place.normalisation=0", "place.patch_radius=4", "place.columns=32", "place.rows=24"}},
       {"gradients, 16x12",
        {"place.cells=gradients", "place.columns=16", "place.rows=12", "place.shift=3",
         "place.vertical_shift=1"}}}));
  const Table page = tableOf(readText(inSource("docs/camera-maps.md")), head);
  REQUIRE(page.thresholds.size() == 10);
  for (std::size_t i = 0; i < page.thresholds.size(); ++i) {
    CAPTURE(head, page.thresholds[i]);
    Cells all = settings;
    all.push_back("place.threshold=" + page.thresholds[i]);
    const auto [precision, recall] = measured(*data, all);
    CHECK(precision == page.precision.at(i));
    CHECK(recall == page.recall.at(i));
  }
}
