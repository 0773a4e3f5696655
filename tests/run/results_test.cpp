// SPDX-License-Identifier: BSD-3-Clause
// Results are made of the rows that the run wrote.
#include "engine/results.hpp"

#include <catch2/catch.hpp>

#include "end_to_end/process.hpp"
#include "end_to_end/record_rows.hpp"
#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::test;

TEST_CASE("rows that another program changed while the run went on give no results") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 12);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const auto run = folder.path() / "run";
  REQUIRE(tolman::test::tolman(tinyRun(config, run)).exit_code == 0);
  CHECK(run::writeResults(run, {}, 1).isOk());
  const auto [name, change] =
      GENERATE(table<std::string, std::string>({{"motion", "T_previous_current_z = 9"},
                                                {"timing", "duration_ns = 1"},
                                                {"frame", "T_world_camera_truth_x = 2"}}));
  editRecord(run, "UPDATE " + name + " SET " + change + " WHERE frame = 7");
  const Status status = run::writeResults(run, {}, 1).status();
  CHECK_THAT(status.message(), Catch::Contains("run.sqlite: the rows of table '" + name +
                                               "' are not those that the run wrote"));
}
