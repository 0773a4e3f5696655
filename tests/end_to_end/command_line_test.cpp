// SPDX-License-Identifier: BSD-3-Clause
// Random command lines of existing words, wrong values and misplaced options. All end with an exit
// code of the table, and with a message unless they succeed.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
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
  for (int i = 0; i < 20; ++i) {
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
  for (int i = 0; i < 12; ++i) {
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
  CHECK(refused > 4);
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

TEST_CASE("a baseline of a wrong unit is told before and during the run, with the remedy") {
  const TemporaryFolder folder;
  const fs::path sequence = folder.path() / "sequence";
  writeTinyKitti(sequence, 6);
  const fs::path config = writeTinyConfig(folder.path(), sequence);
  const auto told = [&](const std::string& text) {
    return contains(text, "the two cameras are") && contains(text, "in metres, not mm");
  };
  std::ofstream(sequence / "calib.txt") << "P0: 100 0 80 0 0 100 30 0 0 0 1 0\n"
                                        << "P1: 100 0 80 -0.12 0 100 30 0 0 0 1 0\n";
  const Finished near = tolman::test::tolman({"dataset", "check", sequence.string()});
  CAPTURE(near.out, near.err);
  CHECK(told(near.out));
  CHECK(contains(near.out, "0.0012 m apart"));
  const fs::path out = folder.path() / "run";
  const Finished ran = tolman::test::tolman(tinyRun(config, out));
  CAPTURE(ran.exit_code, ran.err);
  CHECK(told(readText(out / "log.txt")));
  std::ofstream(sequence / "calib.txt") << "P0: 100 0 80 0 0 100 30 0 0 0 1 0\n"
                                        << "P1: 100 0 80 -50 0 100 30 0 0 0 1 0\n";
  CHECK_FALSE(told(tolman::test::tolman({"dataset", "check", sequence.string()}).out));
}
