// SPDX-License-Identifier: BSD-3-Clause
// Short names of runs.
#include <catch2/catch.hpp>

#include "engine/results.hpp"

using tolman::engine::distinctNames;
using Names = std::vector<std::string>;
TEST_CASE("runs have the names of their directories") {
  CHECK(distinctNames({"runs/demo"}) == Names{"demo"});
  CHECK(distinctNames({"", "runs/demo"}) == Names{"", "demo"});  // refused where it is opened
  CHECK(distinctNames({"runs/demo/", "runs/other/."}) == Names{"demo", "other"});
}

TEST_CASE("what all paths end with tells nothing, as run/ of the points of a sweep") {
  CHECK(distinctNames({"sweeps/s/p1/run", "sweeps/s/p2/run", "sweeps/s/p3/run"}) ==
        Names{"p1", "p2", "p3"});
}

TEST_CASE("equal names get the folders above") {
  CHECK(distinctNames({"/a/x/demo", "/b/x/demo", "/c/x/other"}) ==
        Names{"a-x-demo", "b-x-demo", "c-x-other"});
  CHECK(distinctNames({"/demo", "/b/demo"}) == Names{"demo", "b-demo"});
}

TEST_CASE("a directory that is given twice gets a number") {
  CHECK(distinctNames({"runs/demo", "runs/demo"}) == Names{"demo", "demo-2"});
  CHECK(distinctNames({"runs/demo", "runs/b", "runs/demo"}) == Names{"demo", "b", "demo-2"});
}
