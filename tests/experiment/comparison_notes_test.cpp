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
