// SPDX-License-Identifier: BSD-3-Clause
// Runs that are given twice count once, or are refused if they differ.
#include <catch2/catch.hpp>

#include "base/must.hpp"
#include "experiment/comparison.hpp"

using namespace tolman;
using namespace tolman::experiment;

namespace {

RunRow repeatedRow(const std::string& sweep, const std::string& period, int seed, double error) {
  RunRow row;
  row.factors = {{"period", period}, {"seed", std::to_string(seed)}};
  row.name = period + "/" + std::to_string(seed);
  row.directory = sweep;
  row.metrics = {{"map.ate.rmse_m", error}, {"timing.map.mean_ms", 0.1 * error}};
  row.alignment = "se2";
  row.results = "digest of " + row.name;
  return row;
}

std::vector<RunRow> sweep(const std::string& name) {
  std::vector<RunRow> rows;
  for (const int seed : {1, 2, 3}) {
    rows.push_back(repeatedRow(name, "75", seed, seed));
    rows.push_back(repeatedRow(name, "150", seed, 10 + seed));
  }
  return rows;
}

std::vector<RunRow> together(std::vector<RunRow> rows, const std::vector<RunRow>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

/// A copy whose second run of the period 75 has another result.
std::vector<RunRow> changed() {
  std::vector<RunRow> rows = sweep("b");
  rows[2].metrics["map.ate.rmse_m"] = 99;
  rows[2].results = "another";
  return rows;
}

constexpr const char* kRefusal =
    "'75/2' (a) and '75/2' (b) are of one setting, with the same factors and seed, and have "
    "different results; leave one of them out";

}  // namespace

TEST_CASE("of runs with the same factors, seed and results one is left") {
  std::vector<RunRow> rows = together(sweep("a"), sweep("b"));
  CHECK(mergeRepeats(rows) ==
        "6 of 12 runs were given twice: another of the same factors and seed has the same results. "
        "They count once.");
  REQUIRE(rows.size() == 6);
  CHECK(rows[5].directory == "a");
  CHECK(mergeRepeats(rows).empty());
  rows = together(sweep("a"), changed());
  const auto refused = resultOf([&] { return mergeRepeats(rows); });
  CHECK(refused.status().message() == kRefusal);
}

TEST_CASE("the order of factors does not matter, and without digests the figures decide") {
  std::vector<RunRow> rows = {repeatedRow("a", "75", 1, 1), repeatedRow("b", "75", 1, 1)};
  std::swap(rows[1].factors[0], rows[1].factors[1]);
  for (RunRow& r : rows) r.results.clear();
  rows[1].metrics["timing.map.mean_ms"] = 7;  // a slower computer
  std::vector<RunRow> same = rows;
  CHECK_FALSE(mergeRepeats(same).empty());
  CHECK(same.size() == 1);
  rows[1].metrics["map.ate.rmse_m"] = 1 + 1e-15;
  CHECK_THROWS_AS(mergeRepeats(rows), Refused);
}

TEST_CASE("a comparison of a sweep with its copy is that of the sweep, and says so") {
  const auto once = compareRuns(sweep("a"), {});
  const auto twice = compareRuns(together(sweep("a"), sweep("b")), {});
  REQUIRE(once.isOk());
  REQUIRE(twice.isOk());
  REQUIRE(twice.value().levels.size() == 2);
  CHECK(twice.value().levels[1].summary.count == 3);
  CHECK(twice.value().levels[1].interval->low == once.value().levels[1].interval->low);
  REQUIRE(twice.value().notes.size() == 1);
  CHECK_THAT(twice.value().notes[0], Catch::StartsWith("6 of 12 runs were given twice"));
  CHECK(compareRuns(together(sweep("a"), changed()), {}).status().message() == kRefusal);
}

TEST_CASE("so are the cells of a table") {
  PivotOptions options;
  options.columns = "period";
  options.cell = "{map.ate.rmse_m:.2f}";
  std::vector<RunRow> uneven = sweep("a");
  uneven.push_back(repeatedRow("b", "75", 1, 1));
  const auto table = pivotOf(uneven, options);
  REQUIRE(table.isOk());
  CHECK(table.value().rows[0][1] == "2.00");  // of 1, 2, 3, not of 1, 2, 3, 1
  REQUIRE(table.value().notes.size() == 1);
  CHECK_THAT(table.value().notes[0], Catch::StartsWith("1 of 7 runs were given twice"));
  CHECK(pivotOf(together(sweep("a"), changed()), options).status().message() == kRefusal);
  options.only = {{"period", "150"}};  // those agree
  CHECK(pivotOf(together(sweep("a"), changed()), options).isOk());
}
