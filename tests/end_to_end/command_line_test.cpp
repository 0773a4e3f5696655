// SPDX-License-Identifier: BSD-3-Clause
// Random command lines of existing words, wrong values and misplaced options. All end with an exit
// code of the table, and with a message unless they succeed.
#include <catch2/catch.hpp>
#include <set>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"
#include "tolman/context.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// Runs within a folder of its own, so that nothing is written elsewhere.
Finished runIn(const fs::path& folder, const std::vector<std::string>& words) {
  std::vector<std::string> command = {"env",     "-C", folder.string(),
                                      "timeout", "60", tolmanProgram().string()};
  command.insert(command.end(), words.begin(), words.end());
  return run(command);
}

bool isOfTable(int code) {
  static const std::set<int> kCodes = {0, 2, 3, 4, 5, 6, 7, 8, 9};
  return kCodes.contains(code);
}

}  // namespace

TEST_CASE("words in any order end as the table says") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 2);
  const std::string config = writeTinyConfig(folder.path(), folder.path() / "sequence").string();
  const std::vector<std::string> commands = {"run",  "check",  "plugins", "dataset", "eval",
                                             "plan", "export", "schema",  "report",  "help"};
  const std::vector<std::string> others = {
      config,      "--set",      "seed=3",   "seed=-1",   "odometry.plugin=none",
      "--json",    "--quiet",    "--help",   "--out",     "out",
      "--threads", "0",          "many",     "describe",  "doctor",
      "list",      "kitti",      "sequence", "",          "--",
      "--nothing", "--seed=1e9", "=",        "a.b.c=[1,", "steady",
      "/",         "--set=",     "check",    "-h",        "\xff\xfe"};
  tolman::RandomStream random(55);
  std::set<int> seen;
  for (int i = 0; i < 60; ++i) {
    std::vector<std::string> words = {commands[random.below(commands.size())]};
    for (std::uint64_t k = random.below(5); k > 0; --k) {
      words.push_back(others[random.below(others.size())]);
    }
    const Finished finished = runIn(folder.path(), words);
    CAPTURE(i, words, finished.exit_code, finished.out, finished.err);
    REQUIRE(isOfTable(finished.exit_code));
    if (finished.exit_code != 0) REQUIRE_FALSE(finished.err.empty());
    seen.insert(finished.exit_code);
  }
  CHECK(seen.contains(2));
  CHECK(seen.size() >= 3);
}

TEST_CASE("overrides at random are applied or refused with their origin") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 2);
  const std::string config = writeTinyConfig(folder.path(), folder.path() / "sequence").string();
  const std::vector<std::string> keys = {
      "seed", "threads",      "place.threshold", "cells.period",        "source",      "map.",
      ".",    "observers[0]", "odometry.speed",  "evaluation.sessions", "cells.plugin"};
  const std::vector<std::string> values = {
      "1",  "-1",      "0.5",   "1e400", "nan", "true", "yes",  "[]",
      "{}", "{a: b}",  "[1, 2", "'",     "~",   "",     "0x10", "99999999999999999999",
      "*x", "!!str 3", "joint"};
  const auto check = [&](const std::string& set) {
    return runIn(folder.path(), {"check", config, "--set", set, "--plugin-path",
                                 inBuild("tests/fixtures/plugins/steady")});
  };
  for (const char* set : {"seed=7", "threads=1", "place.threshold=0.5", "cells.period=12",
                          "odometry.speed=-2", "evaluation.sessions=joint", "observers=[]"}) {
    const Finished finished = check(set);
    CAPTURE(set, finished.err);
    CHECK(finished.exit_code == 0);
  }
  tolman::RandomStream random(56);
  int refused = 0;
  for (int i = 0; i < 24; ++i) {
    const std::string set =
        keys[random.below(keys.size())] + "=" + values[random.below(values.size())];
    const Finished finished = check(set);
    CAPTURE(set, finished.exit_code, finished.err);
    REQUIRE((finished.exit_code == 0 || finished.exit_code == 3 || finished.exit_code == 4 ||
             finished.exit_code == 5));
    if (finished.exit_code != 3) continue;
    REQUIRE(contains(finished.err, "--set"));  // where the value comes from
    ++refused;
  }
  CHECK(refused > 8);
}

TEST_CASE("a value given by an option and by --set is refused") {
  const std::vector<std::string> words = {"check", inSource("configs/demo.yaml"), "--set"};
  for (const auto& [set, option] :
       {std::pair<const char*, const char*>("seed=4", "--seed"), {"threads=2", "--threads"}}) {
    std::vector<std::string> both = words;
    both.insert(both.end(), {set, option, "3"});
    const Finished finished = tolman::test::tolman(both);
    CAPTURE(option, finished.err);
    CHECK(finished.exit_code == 2);
    CHECK(contains(finished.err, std::string(option) + " excludes --set "));
  }
}

TEST_CASE("two values of one key are refused, the same value twice is not") {
  const auto check = [](const std::string& first, const std::string& second) {
    return tolman::test::tolman(
        {"check", inSource("configs/demo.yaml"), "--set", first, "--set", second});
  };
  const Finished finished = check("seed=4", "seed=5");
  CHECK(finished.exit_code == 2);
  CHECK(contains(finished.err, "--set seed: is given twice, as '4' and as '5'; give it once"));
  CHECK(check("seed=4", "seed=4").exit_code == 0);
  CHECK(check("seed=4", "threads=1").exit_code == 0);
}

TEST_CASE("check tells that there is no map to continue") {
  const TemporaryFolder folder;
  for (const std::string& none : {std::string("/nope"), folder.path().string()}) {
    const Finished finished =
        tolman::test::tolman({"check", inSource("configs/demo.yaml"), "--set", "continue=" + none});
    CHECK(finished.exit_code == 9);
    CHECK(contains(finished.err, none + ": is no run directory"));
  }
}
