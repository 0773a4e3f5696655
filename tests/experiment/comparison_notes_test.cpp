// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "experiment/comparison.hpp"

namespace tolman::experiment {
namespace {

RunRow rowWith(const std::string& period, const std::string& model, const std::string& sequence,
               const std::string& results) {
  RunRow row;
  row.factors = {{"period", period}, {"model", model}, {"sequence", sequence}, {"seed", "1"}};
  row.results = results;
  return row;
}

}  // namespace

TEST_CASE("a factor is without effect where its levels alone change no byte") {
  std::vector<RunRow> rows;
  for (const char* period : {"75", "150"}) {
    for (const char* model : {"a", "b"}) {
      for (const char* sequence : {"00", "06"}) {
        rows.push_back(rowWith(period, model, sequence, std::string(model) + sequence));
      }
    }
  }
  CHECK(factorsWithoutEffect(rows) == std::vector<std::string>{"period"});
  rows.back().results += " with another period";
  CHECK(factorsWithoutEffect(rows).empty());
}

TEST_CASE("a factor with one level is not without effect, it is not varied") {
  CHECK(
      factorsWithoutEffect({rowWith("75", "a", "00", "x"), rowWith("75", "a", "06", "y")}).empty());
  CHECK(factorsWithoutEffect({}).empty());
}

TEST_CASE("the least possible p is that of differences which all agree") {
  for (const std::size_t n : {1U, 2U, 3U, 4U, 5U}) {
    const double least = signedRank(std::vector<double>(n, 1.0)).p;
    for (const std::string& text : {fewSamplesNote(n, 3), fewSamplesNote(1, n)}) {
      if (n == 1 && text.find("and 3 seeds") != std::string::npos) continue;  // the seeds count
      CHECK(std::stod(text.substr(text.find("below ") + 6)) == Approx(least).epsilon(0.01));
    }
  }
  CHECK(fewSamplesNote(6, 3).empty());
  CHECK(fewSamplesNote(1, 6).empty());
}

TEST_CASE("runs that lost tracking and runs that were interrupted or failed are told apart") {
  std::vector<RunRow> rows(4);
  const int codes[] = {0, 6, 130, 7};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].name = std::string(1, "abcd"[i]);
    rows[i].metrics["exit_code"] = codes[i];
  }
  CHECK(trackingNotes(rows) ==
        std::vector<std::string>{
            "1 of 4 runs ended with exit code 6, odometry was not tracking at their end: b.",
            "2 of 4 runs were interrupted or failed (exit code in brackets), and their figures are "
            "of the part that they drove: c (130), d (7)."});
  CHECK(trackingNotes({rows[0]}).empty());
}

TEST_CASE("labels of one factor are alternatives, those of several are all needed") {
  const RunRow run = rowWith("75", "a", "00", "x");
  CHECK(hasLabels(run, {}));
  CHECK(hasLabels(run, {{"period", "150"}, {"period", "75"}}));
  CHECK(hasLabels(run, {{"period", "75"}, {"model", "a"}}));
  CHECK_FALSE(hasLabels(run, {{"period", "75"}, {"model", "b"}}));
  CHECK_FALSE(hasLabels(run, {{"unknown", "75"}}));
}

}  // namespace tolman::experiment
