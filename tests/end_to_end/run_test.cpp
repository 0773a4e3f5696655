// SPDX-License-Identifier: BSD-3-Clause
// One configuration file runs the whole chain, with every stage from its own library.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <regex>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

struct Tiny {
  TemporaryFolder folder;
  fs::path sequence = folder.path() / "sequence";
  fs::path out = folder.path() / "run";
  fs::path config;

  explicit Tiny(int frames = 30) {
    writeTinyKitti(sequence, frames);
    config = writeTinyConfig(folder.path(), sequence);
  }
  Finished run(const std::vector<std::string>& more = {}, const std::string& to = "run") {
    out = folder.path() / to;
    auto arguments = tinyRun(config, out);
    arguments.insert(arguments.end(), more.begin(), more.end());
    return tolman::test::tolman(arguments);
  }
};

}  // namespace

TEST_CASE("a run leaves a complete directory and true figures") {
  Tiny tiny;
  const Finished finished = tiny.run();
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  for (const char* name :
       {"config.resolved.yaml", "run.json", "run.sqlite", "trajectory.tum", "trajectory.kitti",
        "odometry.tum", "odometry.kitti", "map.g2o", "map.svg", "report.html", "figures/error.svg",
        "metrics.json", "results.sha256", "log.txt"}) {
    CHECK(fs::exists(tiny.out / name));
  }
  const auto metrics = readJson(tiny.out / "metrics.json");
  // The truth goes straight ahead at 10 m/s, and so does the odometry: no error but rounding.
  CHECK(metrics["odometry"]["ate"]["rmse_m"].get<double>() < 1e-6);
  CHECK(metrics["map"]["ate"]["rmse_m"].get<double>() < 1e-6);
  CHECK(metrics["coverage"].get<double>() == 1);
  for (const char* key : {"templates", "experiences", "loop_links", "loop_decisions", "timing"}) {
    CHECK(metrics.contains(key));
  }
  const auto provenance = readJson(tiny.out / "run.json");
  CHECK(provenance["status"] == "finished");
  CHECK(provenance["exit_code"] == 0);
  CHECK(provenance["counters"]["frames"] == 30);
  CHECK(provenance["plugins"].size() == 5);
  CHECK(provenance["plugins"][1]["sha256"].get<std::string>().size() == 64);
  CHECK(contains(finished.out, "tracking  29 of 30 frames, 1 initialising, 0 lost\n"));
  CHECK(contains(finished.out, "30 processed, 0 dropped, 0 skipped, 0 without image\n"));
}

TEST_CASE("a wrong speed shows in the figures") {
  Tiny tiny;
  REQUIRE(tiny.run({"--set", "odometry.speed=11"}).exit_code == 0);
  const auto metrics = readJson(tiny.out / "metrics.json");
  CHECK(metrics["odometry"]["path_length_m"].get<double>() == Approx(31.9));
  // 10 % too fast over 29 m, SE(3)-aligned: errors are linear around the middle.
  CHECK(metrics["odometry"]["ate"]["max_m"].get<double>() == Approx(1.45).epsilon(0.01));
}

TEST_CASE("results are the same bytes for 1, 2 and 4 threads, and from run to run") {
  Tiny tiny(60);
  std::vector<std::string> digests;
  for (const char* threads : {"1", "2", "4", "2"}) {
    REQUIRE(tiny.run({"--threads", threads}, "run" + std::to_string(digests.size())).exit_code ==
            0);
    digests.push_back(readText(tiny.out / "results.sha256"));
  }
  CHECK(contains(digests[0], "trajectory.tum"));
  CHECK(contains(digests[0], "map.g2o"));
  for (const std::string& digest : digests) CHECK(digest == digests[0]);
}

TEST_CASE("the resolved configuration runs again to the same results") {
  Tiny tiny;
  REQUIRE(tiny.run({"--set", "odometry.speed=9"}).exit_code == 0);
  const std::string first = readText(tiny.out / "results.sha256");
  tiny.config = tiny.folder.path() / "again.yaml";
  fs::copy(tiny.out / "config.resolved.yaml", tiny.config);
  REQUIRE(tiny.run({}, "again").exit_code == 0);
  CHECK(readText(tiny.out / "results.sha256") == first);
}

TEST_CASE("realtime: paced by stamps, and every frame is processed or counted as dropped") {
  Tiny tiny(20);
  const Finished finished = tiny.run({"--set", "pipeline.mode=realtime", "--set",
                                      "pipeline.speed=20", "--set", "pipeline.input_policy=block"});
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const auto counters = readJson(tiny.out / "run.json")["counters"];
  CHECK(counters["frames"].get<int>() + counters["dropped"].get<int>() == 20);
}

TEST_CASE("frames that realtime dropped are not covered, and the .kitti files are told to repeat") {
  Tiny tiny(30);
  const Finished finished = tiny.run({"--set", "pipeline={mode: realtime, speed: 1000, queue: 1}"});
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const auto counters = readJson(tiny.out / "run.json")["counters"];
  const auto frames = counters["frames"].get<double>();
  REQUIRE(counters["dropped"] > 0);  // a frame in 0.1 ms
  CHECK(contains(finished.err, "the .kitti files repeat the pose before them"));
  const auto coverage = readJson(tiny.out / "metrics.json")["coverage"].get<double>();
  CHECK(coverage <= frames / (frames + 1) + 1e-9);
  // Also where the last frames were dropped: their events are in the record.
  std::ifstream file(tiny.out / "odometry.kitti");
  const std::string lines(std::istreambuf_iterator<char>(file), {});
  CHECK(std::count(lines.begin(), lines.end(), '\n') == 30);
}

TEST_CASE("--continue and --out take any name as it is") {
  Tiny tiny(4);
  for (const std::string name : {"x", "x #2", "\"q\"", "null", "a: b", "trail "}) {
    INFO(name);
    REQUIRE(tiny.run({}, name).exit_code == 0);
    const Finished next =
        tiny.run({"--continue", (tiny.folder.path() / name).string()}, name + "-next");
    INFO(next.err);
    REQUIRE(next.exit_code == 0);
    const auto run = readJson(tiny.folder.path() / (name + "-next") / "run.json");
    CHECK(run["continued"]["directory"] == (tiny.folder.path() / name).string());
  }
}

TEST_CASE("a map continued with another camera is told") {
  Tiny tiny(6);
  REQUIRE(tiny.run({}, "first").exit_code == 0);
  const std::string first = (tiny.folder.path() / "first").string();
  CHECK_FALSE(contains(tiny.run({"--continue", first}, "same").err, "the camera is another"));
  std::ofstream(tiny.sequence / "calib.txt") << "P0: 120 0 80 0 0 100 30 0 0 0 1 0\n"
                                             << "P1: 120 0 80 -60 0 100 30 0 0 0 1 0\n";
  const Finished other = tiny.run({"--continue", first}, "other");
  INFO(other.err);
  CHECK(other.exit_code == 0);
  const std::string told =
      "the camera is another than in the earlier session (now 160x60 px, fx 120, fy 100, cx 80, cy "
      "30, "
      "baseline 0.5 m, then 160x60 px, fx 100,";
  CHECK(contains(other.err, told));
  CHECK(contains(readText(tiny.folder.path() / "other/log.txt"), told));
}

TEST_CASE("--json shows names that are no UTF-8 with a sign in their place") {
  Tiny tiny(3);
  const Finished finished = tiny.run({"--json"}, "b\xff");
  INFO(finished.err);
  CHECK(finished.exit_code == 0);
  CHECK(nlohmann::json::parse(finished.out)["exit_code"] == 0);
}

TEST_CASE("--json gives one document with figures") {
  Tiny tiny(5);
  const Finished finished = tiny.run({"--json"});
  REQUIRE(finished.exit_code == 0);
  const auto json = nlohmann::json::parse(finished.out);
  CHECK(json["metrics"]["odometry"].contains("ate"));
  CHECK(json["directory"] == tiny.out.string());
}

TEST_CASE("a directory that is no run is not overwritten; an earlier run only by force") {
  Tiny tiny(5);
  fs::create_directories(tiny.folder.path() / "precious");
  { Finished ignored = run({"touch", (tiny.folder.path() / "precious/thesis.tex").string()}); }
  const Finished refused = tiny.run({}, "precious");
  CHECK(refused.exit_code == 8);
  CHECK(contains(refused.err, "precious"));
  CHECK(fs::exists(tiny.folder.path() / "precious/thesis.tex"));
  REQUIRE(tiny.run().exit_code == 0);
  const Finished again = tiny.run();
  CHECK(again.exit_code == 8);
  CHECK(contains(again.err, "holds a run; choose another --out, or give --force to replace it"));
  CHECK(fs::exists(tiny.out / "report.html"));
  CHECK(tiny.run({"--force"}).exit_code == 0);
}
