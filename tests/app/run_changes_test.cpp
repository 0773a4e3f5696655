// SPDX-License-Identifier: BSD-3-Clause
// What `tolman rerun` names as the cause of other results.
#include "app/run_changes.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/data.hpp"

namespace {

using Texts = std::vector<std::string>;

/// Two run directories that have run.json alone.
struct TwoRuns {
  tolman::test::TemporaryFolder before;
  tolman::test::TemporaryFolder after;

  Texts changes(const nlohmann::json& old, const nlohmann::json& now) const {
    std::ofstream(before.path() / "run.json") << old;
    std::ofstream(after.path() / "run.json") << now;
    return tolman::app::resultChanges(before.path(), after.path());
  }
};

}  // namespace

TEST_CASE("frames that a realtime run drops are named as a cause") {
  const TwoRuns runs;
  const auto counters = [](int dropped, int left_out) {
    return nlohmann::json{{"counters", {{"dropped", dropped}, {"place_left_out", left_out}}}};
  };
  CHECK(runs.changes(counters(0, 0), counters(0, 0)).empty());
  CHECK(runs.changes(counters(3, 0), counters(5, 0)) ==
        Texts{"realtime: 3 frames were dropped, then 5; which ones depends on the speed of the "
              "machine"});
  CHECK(runs.changes(counters(3, 1), counters(3, 0)).size() == 2);
  CHECK(runs.changes(nlohmann::json::object(), counters(4, 0)).empty());
}

TEST_CASE("another program, and a changed file of a plugin, are named") {
  const TwoRuns runs;
  const auto run = [](const char* revision, const char* digest) {
    return nlohmann::json{
        {"tolman", {{"revision", revision}}},
        {"plugins", {{{"stage", "map"}, {"id", "m"}, {"file", "m.so"}, {"sha256", digest}}}}};
  };
  CHECK(runs.changes(run("a", "1"), run("a", "1")).empty());
  CHECK(runs.changes(run("a", "1"), run("b", "2")) ==
        Texts{R"(tolman revision: "a" -> "b")", "plugins: m.so has other contents"});
}
