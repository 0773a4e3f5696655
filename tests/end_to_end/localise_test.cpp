// SPDX-License-Identifier: BSD-3-Clause
// A run in the map of another one, which stays as it is: two laps of a square, the first one is
// the map.
#include <catch2/catch.hpp>
#include <fstream>
#include <map>

#include "end_to_end/process.hpp"
#include "end_to_end/record_rows.hpp"
#include "experiment/motion_folder.hpp"
#include "support/data.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

struct Laps {
  TemporaryFolder folder;
  std::string map = (folder.path() / "map").string();
  std::string out = (folder.path() / "out").string();

  Laps() {
    writeMotionFolder(folder.path() / "log");
    const Finished first = drive(map, {"--set", "source.last=199"});
    INFO(first.err);
    REQUIRE(first.exit_code == 0);
  }
  Finished drive(const std::string& to, const Words& more) const {
    const fs::path config = writeMotionConfig(folder.path(), folder.path() / "log");
    Words words = {"run", config.string(), "-q", "--out", to};
    for (const char* set : {"source.truth_origin=data", "evaluation.sessions=joint"}) {
      words.insert(words.end(), {"--set", set});
    }
    words.insert(words.end(), more.begin(), more.end());
    return tolman::test::tolman(words);
  }
  Finished localise(const Words& more = {}) const {
    Words words = {"--localise", map, "--set", "source.first=220", "--force"};
    words.insert(words.end(), more.begin(), more.end());
    return drive(out, words);
  }
  std::map<std::string, std::string> filesOfMap() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(map)) {
      files[entry.path().string()] = entry.is_regular_file() ? readText(entry.path()) : "";
    }
    return files;
  }
};

}  // namespace

TEST_CASE("the robot is found in the map of a run, no file of which changes") {
  const Laps laps;
  const auto before = laps.filesOfMap();
  const Finished finished = laps.localise();
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  CHECK(laps.filesOfMap() == before);

  const auto metrics = readJson(fs::path(laps.out) / "metrics.json");
  const auto found = metrics["localisation"];
  INFO(found.dump());
  REQUIRE(found["searches"].size() == 1);
  CHECK(found["searches"][0]["found"] == true);
  CHECK(found["searches"][0]["metres"].get<double>() >= 15);  // several views agree
  CHECK(found["searches"][0]["metres"].get<double>() <= 25);
  CHECK(found["wrong"] == 0);
  CHECK(found["error_m"]["max"].get<double>() < 1);
  CHECK(contains(metrics["verdicts"][0].get<std::string>(), "found itself 1 of 1 times"));
  for (const char* size : {"experiences", "links"}) {
    CHECK(metrics[size] == readJson(fs::path(laps.map) / "metrics.json")[size]);
  }
  const auto statuses = recordRows(
      laps.out,
      "SELECT sum(status = 'unknown_place'), sum(status = 'found'), count(*) FROM localisation");
  CHECK(statuses[0][0] == found["unknown"].get<double>());
  CHECK(statuses[0][1] == found["found"].get<double>());
  CHECK(statuses[0][2] == 181);

  const Finished way =
      tolman::test::tolman({"plan", laps.out, "--from", "here", "--to", "10", "--json"});
  INFO(way.err);
  CHECK(way.exit_code == 0);
  const Finished on = laps.drive(laps.out + "-on", {"--continue", laps.out});
  CHECK(on.exit_code == 9);  // it has no map of its own
}

TEST_CASE("a robot that is carried away is at an unknown place, and found again") {
  const Laps laps;
  const Finished finished = laps.localise({"--set", "odometry.carried_at=80"});
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const auto found = readJson(fs::path(laps.out) / "metrics.json")["localisation"];
  REQUIRE(found["searches"].size() == 2);
  CHECK(found["searches"][1]["first_frame"] == 280);
  CHECK(found["searches"][1]["found"] == true);
  CHECK(found["wrong"] == 0);
}

TEST_CASE("a plugin that would change the map is refused, with those that would not") {
  const Laps laps;
  const Finished finished = laps.localise({"--set", "cells={plugin: pose_cells}"});
  CHECK(finished.exit_code == 4);
  CHECK(contains(finished.err, "plugin 'pose_cells' cannot use a map without changing it"));
  CHECK(contains(finished.err, "bayesian_attractor"));
  CHECK_FALSE(fs::exists(laps.out));
}
