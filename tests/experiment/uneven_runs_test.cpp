// SPDX-License-Identifier: BSD-3-Clause
// Comparisons of sweeps in which runs are missing, because they failed or were left out.
#include <algorithm>
#include <catch2/catch.hpp>

#include "experiment/comparison.hpp"
#include "experiment/tables.hpp"

namespace tolman::experiment {
namespace {

RunRow runOf(const std::string& model, const std::string& sequence, int seed, double error) {
  RunRow row;
  row.factors = {{"model", model}, {"sequence", sequence}, {"seed", std::to_string(seed)}};
  row.name = model + "/" + sequence + "/" + std::to_string(seed);
  row.metrics = {{"map.ate.rmse_m", error}, {"map.coverage", 1.0}};
  row.alignment = "se2";
  row.truth = "truth of " + sequence;
  row.results = row.name;
  return row;
}

bool hasNote(const std::vector<std::string>& notes, const std::string& text) {
  return std::ranges::any_of(
      notes, [&](const auto& note) { return note.find(text) != std::string::npos; });
}

const Level& levelOf(const Comparison& comparison, const std::string& label) {
  return *std::ranges::find(comparison.levels, label, &Level::label);
}

}  // namespace

TEST_CASE("of fewer than three pairs no interval and no test is given") {
  std::vector<RunRow> rows;
  for (const int seed : {1, 2, 3}) rows.push_back(runOf("a", "x", seed, 10 + seed));
  for (const int seed : {3, 4, 5}) rows.push_back(runOf("b", "x", seed, 20 + seed));
  const auto compared = compareRuns(rows, {});
  REQUIRE(compared.isOk());
  const Level& b = levelOf(compared.value(), "b");
  CHECK(b.interval);  // of its own three runs
  REQUIRE(b.difference);
  CHECK(b.difference->pairs == 1);
  CHECK(b.difference->mean == 10);
  CHECK_FALSE(b.difference->interval);
  CHECK_FALSE(b.difference->test);
}

TEST_CASE("a level with one of several sequences is not tested over seeds") {
  std::vector<RunRow> rows;
  for (int seed = 1; seed <= 8; ++seed) {
    rows.push_back(runOf("a", "x", seed, 10 + seed));
    rows.push_back(runOf("a", "y", seed, 30 + seed));
    rows.push_back(runOf("b", "x", seed, 11 + 1.1 * seed));
  }
  const auto compared = compareRuns(rows, {});
  REQUIRE(compared.isOk());
  const auto& difference = levelOf(compared.value(), "b").difference;
  REQUIRE(difference);
  CHECK(difference->pairs == 8);
  CHECK_FALSE(difference->interval);
  CHECK_FALSE(difference->test);
}

TEST_CASE("a note says when mean and interval weigh runs differently") {
  std::vector<RunRow> rows;
  for (const char* model : {"a", "b"}) {
    for (int seed = 1; seed <= 10; ++seed) rows.push_back(runOf(model, "x", seed, 1 + seed));
    for (int seed = 1; seed <= 3; ++seed) rows.push_back(runOf(model, "y", seed, 100 + seed));
  }
  const std::string text = "the mean need not lie in its interval";
  CHECK(hasNote(compareRuns(rows, {}).value().notes, "Sequences or levels have different numbers"));
  CHECK(hasNote(compareRuns(rows, {}).value().notes, text));
  std::erase_if(rows, [](const RunRow& row) { return std::stoi(row.label("seed")) > 3; });
  CHECK_FALSE(hasNote(compareRuns(rows, {}).value().notes, text));
}

TEST_CASE("the order of factors in a table does not matter") {
  std::vector<RunRow> rows;
  for (int seed = 1; seed <= 3; ++seed) {
    rows.push_back(runOf("a", "x", seed, seed));
    rows.push_back(runOf("b", "x", seed, 2 * seed));
    for (RunRow* row : {&rows[rows.size() - 2], &rows.back()})
      row->factors.push_back({"z", "same"});
    std::ranges::reverse(rows.back().factors);
  }
  const auto compared = compareRuns(rows, {});
  REQUIRE(compared.isOk());
  CHECK(levelOf(compared.value(), "b").difference->pairs == 3);
}

TEST_CASE("results without a digest are not called equal") {
  std::vector<RunRow> rows;
  for (int seed = 1; seed <= 3; ++seed) rows.push_back(runOf("a", "x", seed, seed));
  for (RunRow& row : rows) row.results.clear();
  const auto compared = compareRuns(rows, {});
  REQUIRE(compared.isOk());
  CHECK_FALSE(hasNote(compared.value().notes, "byte for byte"));
  CHECK(compared.value().levels[0].interval);
}

TEST_CASE("a table in CSV has empty fields where there are no pairs and no deviation") {
  const auto compared = compareRuns({runOf("a", "x", 1, 4), runOf("b", "x", 2, 5)}, {});
  REQUIRE(compared.isOk());
  CHECK(csvOf(tableOf(compared.value())) ==
        "model,runs,mean,mean_low,mean_high,median,sd,min,max,pairs,difference,difference_low,"
        "difference_high,p,effect\n"
        "a,1,4,,,4,,4,4,,,,,,\n"
        "b,1,5,,,5,,5,5,0,,,,,\n");
}

TEST_CASE("cells do not average what a comparison refuses, and say of how many runs they are") {
  PivotOptions options;
  options.columns = "model";
  options.cell = "{map.kitti.t_rel_percent}";
  std::vector<RunRow> rows = {runOf("a", "x", 1, 4), runOf("a", "x", 2, 5), runOf("b", "x", 1, 6)};
  for (RunRow& row : rows) {
    row.metrics["map.kitti.t_rel_percent"] = 1;
    row.metrics["map.kitti.lengths_m.0"] = 100;
  }
  rows[2].metrics["exit_code"] = 130;
  const auto table = pivotOf(rows, options);
  REQUIRE(table.isOk());
  CHECK(hasNote(table.value().notes, "different numbers of runs, 1 to 2"));
  CHECK(hasNote(table.value().notes, "1 of 3 runs were interrupted or failed"));
  rows[1].metrics["map.kitti.lengths_m.0"] = 200;
  CHECK(pivotOf(rows, options).status().message().find("segments of 100 to 100 m and of 200") !=
        std::string::npos);
}

}  // namespace tolman::experiment
