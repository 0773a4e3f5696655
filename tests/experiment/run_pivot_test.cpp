// SPDX-License-Identifier: BSD-3-Clause
// Tables with a column for each level of a factor, and the text of tables.
#include <catch2/catch.hpp>
#include <fstream>

#include "experiment/comparison.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::experiment;

namespace {

RunRow modelRow(const std::string& model, const std::string& sequence, int seed, double error) {
  RunRow row;
  row.factors = {{"model", model}, {"sequence", sequence}, {"seed", std::to_string(seed)}};
  row.name = model + "/" + sequence + "/" + std::to_string(seed);
  row.metrics = {{"map.ate.rmse_m", error}, {"loops.true_links", 10 * error}};
  row.alignment = "se2";
  row.truth = "t" + sequence;
  row.results = "r" + sequence + "/" + std::to_string(seed) + model.front();
  return row;
}

std::vector<RunRow> modelRows() {
  return {modelRow("a", "00", 1, 1), modelRow("a", "00", 2, 2),    modelRow("a", "05", 1, 4),
          modelRow("a", "05", 2, 4), modelRow("b, c", "00", 1, 8), modelRow("b, c", "00", 2, 8)};
}

PivotOptions options() {
  PivotOptions options;
  options.columns = "sequence";
  options.cell = "{map.ate.rmse_m:.2f} ({loops.true_links:.0f})";
  return options;
}

}  // namespace

TEST_CASE("cells have the means over seeds, and stay empty without runs") {
  PivotOptions asked = options();
  asked.heads = {{"loops", "{loops.true_links:.1f}"}};
  const auto table = pivotOf(modelRows(), asked);
  REQUIRE(table.isOk());
  CHECK(table.value().heading == std::vector<std::string>{"model", "00", "05"});
  CHECK(table.value().rows == std::vector<std::vector<std::string>>{{"loops", "15.0", "40.0"},
                                                                    {"a", "1.50 (15)", "4.00 (40)"},
                                                                    {"b, c", "8.00 (80)", ""}});
  CHECK(csvOf(table.value()) ==
        "model,00,05\nloops,15.0,40.0\na,1.50 (15),4.00 (40)\n\"b, c\",8.00 (80),\n");
  CHECK(markdownOf(table.value()).starts_with("| model | 00 | 05 |\n|---|---:|---:|\n"));
  CHECK(latexOf(table.value()).find("a & 1.50 (15) & 4.00 (40) \\\\\n") != std::string::npos);
}

TEST_CASE("a column for each of several metrics") {
  PivotOptions asked;
  asked.by = {"model", "sequence"};
  asked.values = {{"error, m", "{map.ate.rmse_m:.2f}"}, {"loops", "{loops.true_links:.0f} true"}};
  const auto table = pivotOf(modelRows(), asked);
  REQUIRE(table.isOk());
  CHECK(table.value().heading == std::vector<std::string>{"model, sequence", "error, m", "loops"});
  CHECK(table.value().rows ==
        std::vector<std::vector<std::string>>{{"a, 00", "1.50", "15 true"},
                                              {"a, 05", "4.00", "40 true"},
                                              {"b, c, 00", "8.00", "80 true"}});
  asked.by = {"model"};
  CHECK_FALSE(pivotOf(modelRows(), asked).isOk());  // two sequences in one cell
  asked.over = {"sequence"};
  CHECK(pivotOf(modelRows(), asked).value().rows[0] ==
        std::vector<std::string>{"a", "2.75", "28 true"});
  asked.over.clear();
  asked.by.clear();  // all factors but the seed
  CHECK(pivotOf(modelRows(), asked).value().rows.size() == 3);
}

TEST_CASE("runs of one cell must not differ in alignment, truth or coverage") {
  const auto refusal = [](const auto& change, const PivotOptions& asked) {
    std::vector<RunRow> all = modelRows();
    change(all[1]);
    return pivotOf(all, asked).status().message();
  };
  const auto lost = [](RunRow& r) { r.metrics["map.coverage"] = 0.6; };
  CHECK_THAT(refusal(lost, options()), Catch::Contains("cover 100.0 % and 60.0 % of the truth"));
  PivotOptions apart = options();
  apart.by = {"model", "seed"};
  CHECK(refusal(lost, apart).empty());  // cells of one run each
  CHECK_THAT(refusal([](RunRow& r) { r.alignment = "sim3"; }, options()),
             Catch::Contains("are aligned by se2 and sim3"));
  CHECK_THAT(refusal([](RunRow& r) { r.truth = "other"; }, options()),
             Catch::Contains("have different true poses"));
}

TEST_CASE("what is no table is refused") {
  const auto message = [](const PivotOptions& asked) {
    const auto table = pivotOf(modelRows(), asked);
    return table.isOk() ? std::string("none") : table.status().message();
  };
  PivotOptions asked = options();
  asked.columns = "sequenc";
  CHECK(message(asked).find("did you mean 'sequence'") != std::string::npos);
  asked = options();
  asked.cell = "{map.ate.rmse:.2f}";
  CHECK(message(asked) == "no run has the metric 'map.ate.rmse'");
  asked.cell = "{map.ate.rmse_m:.2q}";
  CHECK(message(asked).starts_with("'{:.2q}': "));
  asked.cell = "{map.ate.rmse_m:100.17f}";
  CHECK(message(asked) == "none");
  asked.cell = "{map.ate.rmse_m";
  CHECK(message(asked).find("'}' is missing") != std::string::npos);
  asked = options();
  asked.by = {"seed"};
  CHECK(message(asked).find("would be one cell; name 'model'") != std::string::npos);
  asked.only = {{"model", "none"}};
  CHECK(message(asked) == "no run has model=none; values: a, b, c");
}

TEST_CASE("a table that was cut after its first line is told as that") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "runs.csv";
  const std::string text = csvOf(tableOf(modelRows()));
  std::ofstream(file) << text.substr(0, text.find('\n') + 1);
  CHECK(readRunRows({file}).status().message() ==
        file.string() + ": is no table of `tolman sweep collect`: it has no line after the first");
}

TEST_CASE("a folder to compare that does not exist is told as that") {
  const test::TemporaryFolder folder;
  const auto nowhere = folder.path() / "nowhere";
  CHECK(readRunRows({nowhere}).status().message() ==
        nowhere.string() + ": does not exist; check the path");
  CHECK(readRunRows({folder.path()}).status().message().find("metrics.json: is missing") !=
        std::string::npos);
}

TEST_CASE("a table of runs is read as it was written") {
  const test::TemporaryFolder folder;
  std::vector<RunRow> written = modelRows();
  written[0].metrics["map.ate.rmse_m"] = 0.1 + 0.2;
  const auto file = folder.path() / "runs.csv";
  std::ofstream(file) << csvOf(tableOf(written));
  const auto read = readRunRows({file});
  REQUIRE(read.isOk());
  REQUIRE(read.value().size() == written.size());
  for (std::size_t i = 0; i < written.size(); ++i) {
    CHECK(read.value()[i].name == written[i].name);
    CHECK(read.value()[i].metrics == written[i].metrics);  // to the last bit
    CHECK(read.value()[i].label("model") == written[i].label("model"));
    CHECK(read.value()[i].truth == written[i].truth);
    CHECK(read.value()[i].results == written[i].results);
  }
  CHECK(csvOf(tableOf(written, {"loops.true_links"})).find("rmse") == std::string::npos);
  std::ofstream(file) << "name,model\na,b\n";
  const auto refusal = [&] { return readRunRows({file}).status().message(); };
  CHECK(
      refusal().ends_with("its first line has no alignment, truth and results after the factors"));
  std::ofstream(file) << "name,model,alignment,truth,results,ate\na,b,se2,t,r,1\na,b,se2,t,r,nan\n";
  CHECK(refusal().ends_with("line 3, ate: 'nan' is no number"));
  std::ofstream(file) << "name,model,alignment,truth,results,ate\na,b,se2\n";
  CHECK(refusal().ends_with("line 2 has 3 fields, the first 6"));
}
