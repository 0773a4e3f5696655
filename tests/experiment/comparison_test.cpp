// SPDX-License-Identifier: BSD-3-Clause
// Comparisons of synthetic runs, whose numbers are known.
#include "experiment/comparison.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "experiment/tables.hpp"

using namespace tolman;
using namespace tolman::experiment;

namespace {

RunRow row(const std::string& period, const std::string& sequence, int seed, double error) {
  RunRow row;
  row.factors = {{"cells.period", period}, {"sequence", sequence}, {"seed", std::to_string(seed)}};
  row.name = period + "/" + sequence + "/" + std::to_string(seed);
  row.metrics = {{"map.ate.rmse_m", error}, {"map.coverage", 1.0}};
  row.alignment = "se2";
  row.truth = "truth of " + sequence;
  row.results = row.name;
  return row;
}

/// Two periods, two sequences, three seeds; the second period is worse by 1 on a and by 3 on b.
std::vector<RunRow> rows() {
  std::vector<RunRow> all;
  for (int seed = 1; seed <= 3; ++seed) {
    all.push_back(row("75", "a", seed, 10 + seed));
    all.push_back(row("150", "a", seed, 11 + seed));
    all.push_back(row("75", "b", seed, 20 + 5 * seed));
    all.push_back(row("150", "b", seed, 23 + 5 * seed));
  }
  return all;
}

}  // namespace

TEST_CASE("levels, and differences paired over sequences and seeds") {
  const auto compared = compareRuns(rows(), {});
  REQUIRE(compared.isOk());
  const Comparison& c = compared.value();
  CHECK(c.by == std::vector<std::string>{"cells.period"});
  REQUIRE(c.levels.size() == 2);
  CHECK(c.levels[0].label == "75");  // by number
  CHECK(c.levels[0].summary.mean == Approx((12 + 30) / 2.0));
  CHECK_FALSE(c.levels[0].difference);
  const auto& difference = c.levels[1].difference;
  REQUIRE(difference);
  CHECK(difference->pairs == 6);
  CHECK(difference->mean == Approx(2));
  REQUIRE(difference->interval);  // of two sequences with constant differences 1 and 3
  CHECK(difference->interval->low == Approx(1));
  CHECK(difference->interval->high == Approx(3));
  REQUIRE(difference->test);
  CHECK(difference->test->n == 2);  // sequences, not runs
  CHECK(difference->test->p == Approx(0.5));
  CHECK(c.notes.empty());
}

TEST_CASE("without --by the levels are those of all factors that vary") {
  std::vector<RunRow> all;
  for (const RunRow& r : rows()) {
    for (const char* model : {"a", "b"}) {
      RunRow more = r;
      more.factors.push_back({"model", model});
      more.factors.push_back({"map", "always this"});
      more.results += model;
      all.push_back(more);
    }
  }
  const auto compared = compareRuns(all, {});
  REQUIRE(compared.isOk());
  CHECK(compared.value().by == std::vector<std::string>{"cells.period", "model"});
  ComparisonOptions options;
  options.only = {{"cells.period", "75"}};
  CHECK(compareRuns(all, options).value().by == std::vector<std::string>{"model"});
}

TEST_CASE("one sequence: the test is over its seeds") {
  ComparisonOptions options;
  options.only = {{"sequence", "b"}};
  options.baseline = "150";
  const auto compared = compareRuns(rows(), options);
  REQUIRE(compared.isOk());
  const auto& difference = compared.value().levels[0].difference;
  REQUIRE(difference);
  CHECK(difference->mean == Approx(-3));
  CHECK(difference->test->n == 3);
  CHECK(difference->test->p == Approx(0.25));
  CHECK(difference->test->effect == -1);
}

TEST_CASE("levels of another factor are no further seeds: their mean counts once a seed") {
  std::vector<RunRow> all;
  for (const RunRow& r : rows()) {
    for (const int level : {0, 1, 2, 3}) {  // hardly another result
      RunRow more = r;
      more.factors.push_back({"noise", std::to_string(level)});
      more.results += std::to_string(level);
      more.metrics["map.ate.rmse_m"] += 1e-4 * level;
      all.push_back(more);
    }
  }
  ComparisonOptions options;
  options.by = {"cells.period"};
  options.only = {{"sequence", "b"}};
  const auto one = compareRuns(rows(), options).value().levels[1];
  const auto many = compareRuns(all, options).value().levels[1];
  CHECK(many.summary.count == 4 * one.summary.count);
  CHECK(many.difference->test->n == 3);
  CHECK(many.difference->test->p == one.difference->test->p);
  CHECK(many.interval->low == Approx(one.interval->low).margin(1e-3));
  CHECK(many.interval->high == Approx(one.interval->high).margin(1e-3));
  options.only.clear();
  const auto both = compareRuns(all, options).value().levels[1];
  CHECK(both.interval->low ==
        Approx(compareRuns(rows(), options).value().levels[1].interval->low).margin(1e-3));
}

TEST_CASE("below three seeds there are no intervals") {
  std::vector<RunRow> few = rows();
  std::erase_if(few, [](const RunRow& r) { return r.label("seed") == "3"; });
  const auto compared = compareRuns(few, {});
  REQUIRE(compared.isOk());
  CHECK_FALSE(compared.value().levels[0].interval);
  CHECK_FALSE(compared.value().levels[1].difference->test);
  REQUIRE(compared.value().notes.size() == 1);
  CHECK(compared.value().notes[0].starts_with("Not enough runs"));
  CHECK(markdownOf(tableOf(compared.value())).find("not enough runs") != std::string::npos);
}

TEST_CASE("seeds with equal results count as one run") {
  std::vector<RunRow> equal = rows();
  for (RunRow& r : equal) r.results = r.label("cells.period") + r.label("sequence");
  const auto compared = compareRuns(equal, {});
  REQUIRE(compared.isOk());
  REQUIRE(compared.value().notes.size() == 2);
  CHECK(compared.value().notes[0].starts_with("In 4 of 4 settings several seeds gave the same"));
  CHECK_FALSE(compared.value().levels[0].interval);
}

TEST_CASE("drifts over segments of different lengths are not averaged") {
  std::vector<RunRow> all = rows();
  for (RunRow& r : all) {
    r.metrics["map.kitti.t_rel_percent"] = 1;
    const bool is_short = r.label("sequence") == "b";
    r.metrics["map.kitti.lengths_m.0"] = is_short ? 5 : 100;
    r.metrics["map.kitti.lengths_m.1"] = is_short ? 50 : 800;
  }
  ComparisonOptions options;
  options.metric = "t_rel_percent";
  const Status status = compareRuns(all, options).status();
  CHECK(status.code() == StatusCode::InvalidInput);
  CHECK(status.message() ==
        "'75/a/1' and '75/b/1' have drifts over segments of 100 to 800 m and of 5 to 50 m, which "
        "are not to be averaged; set evaluation.segments, or choose runs with --only");
  options.only = {{"sequence", "a"}};
  CHECK(compareRuns(all, options).isOk());
  options = {};
  CHECK(compareRuns(all, options).isOk());  // other errors have no segments
}

TEST_CASE("runs that lost tracking, and different coverages of the sequences, are reported") {
  std::vector<RunRow> all = rows();
  for (RunRow& r : all) {
    if (r.label("sequence") == "b") r.metrics["map.coverage"] = 0.76;
    r.metrics["exit_code"] = 0;
  }
  all.back().metrics["exit_code"] = 6;
  const auto compared = compareRuns(all, {});
  REQUIRE(compared.isOk());
  REQUIRE(compared.value().notes.size() == 2);
  CHECK(compared.value().notes[0] ==
        "1 of 12 runs ended with exit code 6, odometry was not tracking at their end: 150/b/3.");
  CHECK(compared.value().notes[1] ==
        "The runs cover 76.0 to 100.0 % of their true paths: errors of the lower ones are of the "
        "part that was tracked.");
}

TEST_CASE("runs whose errors must not be averaged are refused") {
  const auto refusal = [](const auto& change) {
    std::vector<RunRow> all = rows();
    change(all.back());
    return compareRuns(all, {}).status();
  };
  const Status alignment = refusal([](RunRow& r) { r.alignment = "sim3"; });
  CHECK(alignment.code() == StatusCode::InvalidInput);
  CHECK(alignment.message().find("aligned by se2 and sim3") != std::string::npos);
  const Status truth = refusal([](RunRow& r) { r.truth = "other"; });
  CHECK(truth.message().find("different true poses") != std::string::npos);
  const Status nothing = refusal([](RunRow& r) { r.metrics["map.coverage"] = 0; });
  CHECK(nothing.message() ==
        "'150/b/3' has not tracked a single frame of the truth, so that its errors are those of "
        "standing still; leave it out with --only");
  const Status coverage = refusal([](RunRow& r) { r.metrics["map.coverage"] = 0.6; });
  CHECK(coverage.message().find("cover 100.0 % and 60.0 %") != std::string::npos);
  ComparisonOptions options;
  std::vector<RunRow> all = rows();
  options.by = {"perriod"};
  CHECK(compareRuns(all, options).status().message().find("factors: cells.period") !=
        std::string::npos);
  options = {};
  options.only = {{"sequence", "c"}};
  CHECK(compareRuns(rows(), options).status().message().starts_with("no run has sequence=c"));
  options = {};
  options.baseline = "1500";
  CHECK(compareRuns(rows(), options).status().message() ==
        "no level '1500'; did you mean '150'?; levels: 75, 150");
  options = {};
  options.metric = "map.atee";
  CHECK(compareRuns(rows(), options).status().code() == StatusCode::InvalidParameter);
  for (RunRow& row : all) row.metrics["odometry.coverage"] = row.metrics["map.coverage"] = 1;
  options.metric = "coverage";
  CHECK(compareRuns(all, options)
            .status()
            .message()
            .find("more than one metric ends with 'coverage': map.coverage, odometry.coverage") ==
        0);
}

TEST_CASE("a metric that only the first run lacks can be compared") {
  std::vector<RunRow> all = rows();
  for (RunRow& row : all) row.metrics["loops"] = 3;
  all.front().metrics.erase("loops");
  ComparisonOptions options;
  options.metric = "loops";
  const auto compared = compareRuns(all, options);
  REQUIRE(compared.isOk());
  CHECK(compared.value().notes.front() == "1 of 12 runs have no loops and are left out.");
}

TEST_CASE("runs without true poses say why they have no errors, and what they have") {
  std::vector<RunRow> all = rows();
  for (RunRow& row : all) {
    row.metrics = {{"loop_links", 3}, {"map.path_length_m", 20}};
    row.truth.clear();
  }
  CHECK(compareRuns(all, {}).status().message() ==
        "no metric 'map.ate.rmse_m' in metrics.json; the runs have no true poses, and so no "
        "errors; set --metric, for example to one of: loop_links");
  ComparisonOptions options;
  options.metric = "loop_links";
  CHECK(compareRuns(all, options).isOk());
}

TEST_CASE("tables as Markdown, LaTeX and CSV") {
  const Table table = tableOf(compareRuns(rows(), {}).value());
  const std::string markdown = markdownOf(table);
  CHECK(markdown.starts_with("| cells.period | runs | mean | 95 % interval |"));
  CHECK(markdown.find("| 150 | 6 | 23 |") != std::string::npos);
  CHECK(markdown.find("| +2 | 1 to 3 | 0.500 | +1.00 |") != std::string::npos);
  CHECK(latexOf(table).find("\\toprule\ncells.period & runs & mean & 95 \\% interval") !=
        std::string::npos);
  const std::string csv = csvOf(table);
  CHECK(csv.find("\n75,6,21,") != std::string::npos);
  CHECK(csv.find(",,,,,,\n") != std::string::npos);  // the baseline has no difference
}

TEST_CASE("as JSON, with exact numbers, and null for what too few runs do not show") {
  std::vector<RunRow> few = rows();
  std::erase_if(few, [](const RunRow& run) { return run.label("seed") == "3"; });
  const auto json = nlohmann::json::parse(jsonOf(tableOf(compareRuns(few, {}).value())));
  CHECK(json["by"] == std::vector<std::string>{"cells.period"});
  CHECK(json["baseline"] == "75");
  REQUIRE(json["rows"].size() == 2);
  const auto& row = json["rows"][1];
  CHECK(row["cells.period"] == "150");
  CHECK(row["runs"] == 4);
  CHECK(row["mean_low"].is_null());
  CHECK(row["pairs"] == 4);
  CHECK(row["difference"] == Approx(2));
  CHECK(json["rows"][0]["difference"].is_null());  // the baseline
  CHECK_FALSE(json["notes"].empty());
}

TEST_CASE("numbers give a line with a band, names give boxes") {
  const std::string line = levelsFigure(compareRuns(rows(), {}).value());
  CHECK(line.find("<polyline") != std::string::npos);
  CHECK(line.find("map.ate.rmse_m") != std::string::npos);
  std::vector<RunRow> named = rows();
  for (RunRow& r : named) r.factors[0].label = r.factors[0].label == "75" ? "paper" : "full";
  const Comparison boxes = compareRuns(named, {}).value();
  CHECK(levelsFigure(boxes).find(">paper<") != std::string::npos);
  CHECK(levelsFigure(boxes).find("<circle") != std::string::npos);
  // Several true paths.
  CHECK(mapsFigure(boxes).status().message().find("--only sequence") != std::string::npos);
}

TEST_CASE("runs outside a sweep that differ in several keys are each a level, under their names") {
  std::vector<RunRow> runs = {row("75", "a", 1, 10), row("150", "a", 1, 12)};
  for (RunRow& run : runs) run.is_alone = true;
  CHECK(compareRuns(runs, {}).value().by == std::vector<std::string>{"cells.period"});
  runs[0].factors.push_back({"map.loss", "huber"});
  runs[1].factors.push_back({"map.loss", "cauchy"});
  const Comparison c = compareRuns(runs, {}).value();
  REQUIRE(c.levels.size() == 2);
  CHECK(c.levels[0].label == "75/a/1");
  CHECK(c.levels[1].label == "150/a/1");
  CHECK(c.levels[1].difference->mean == Approx(2));
}
