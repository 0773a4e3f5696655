// SPDX-License-Identifier: BSD-3-Clause
// Invalid data sets and configurations: one clear message and the right exit code.
#include <catch2/catch.hpp>
#include <fstream>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// A tiny data set that a test damages before it runs.
struct Damaged {
  TemporaryFolder folder;
  fs::path sequence = folder.path() / "sequence";
  fs::path out = folder.path() / "run";
  Damaged() { writeTinyKitti(sequence, 6); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(sequence / name, std::ios::binary) << text;
  }
  void truncate(const std::string& name) const {
    fs::resize_file(sequence / name, fs::file_size(sequence / name) / 2);
  }
  Finished run(const std::vector<std::string>& more = {}) const {
    auto arguments = tinyRun(writeTinyConfig(folder.path(), sequence), out);
    arguments.insert(arguments.end(), more.begin(), more.end());
    return tolman::test::tolman(arguments);
  }
  /// Fails before frame 0, with this in the message.
  void refused(const std::string& part) const {
    const Finished finished = run();
    INFO(finished.err);
    CHECK(finished.exit_code == 5);
    CHECK(contains(finished.err, part));
    CHECK_FALSE(fs::exists(out));
  }
};

}  // namespace

TEST_CASE("data sets that are wrong are refused before frame 0, with exit code 5") {
  const Damaged data;
  SECTION("missing folder") {
    fs::remove_all(data.sequence);
    data.refused(data.sequence.string());
  }
  SECTION("missing right image") {
    fs::remove(data.sequence / "image_1/000003.png");
    data.refused("000003.png: has no partner of the same name");
  }
  SECTION("empty calibration") {
    data.write("calib.txt", "");
    data.refused("calib.txt");
  }
  SECTION("zero baseline") {
    data.write("calib.txt",
               "P0: 100 0 80 0 0 100 30 0 0 0 1 0\nP1: 100 0 80 0 0 100 30 0 0 0 1 0\n");
    data.refused("baseline");
  }
  SECTION("negative baseline") {
    data.write("calib.txt",
               "P0: 100 0 80 0 0 100 30 0 0 0 1 0\nP1: 100 0 80 50 0 100 30 0 0 0 1 0\n");
    data.refused("baseline");
  }
  SECTION("times going back") {
    data.write("times.txt", "0\n0.1\n0.2\n0.15\n0.4\n0.5\n");
    data.refused("image before: time 4 of " + (data.sequence / "times.txt").string());
  }
  SECTION("NaN in poses") {
    data.write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 nan 0 0 0 0 1 1\n");
    data.refused("poses.txt:2");
  }
}

TEST_CASE("a calibration with a key given twice is refused at the second, with exit code 5") {
  const Damaged data;
  data.write("rig.yaml",
             "cam0:\n  camera_model: pinhole\n  intrinsics: [100, 100, 80, 30]\n"
             "  distortion_model: none\n  resolution: [160, 60]\n\n"
             "  intrinsics: [200, 200, 80, 30]\n");
  const std::vector<std::string> source = {
      "dataset",      "check", data.sequence.string(), "--source", "images", "--set",
      "left=image_0", "--set", "calibration=rig.yaml", "--set",    "rate=10"};
  const Finished checked = tolman::test::tolman(source);
  INFO(checked.out << checked.err);
  CHECK(checked.exit_code == 5);
  const std::string wrong = (data.sequence / "rig.yaml").string() +
                            ":7: 'intrinsics' is given twice, first in line 3; remove one of";
  CHECK(contains(checked.out + checked.err, wrong));
  const Finished ran =
      data.run({"--set", "source={plugin: images, path: " + data.sequence.string() +
                             ", left: image_0, calibration: rig.yaml, rate: 10}"});
  CHECK(ran.exit_code == 5);
  CHECK(contains(ran.err, wrong));
}

TEST_CASE("a damaged image stops the run with what was done recorded, or its frame is left out") {
  const Damaged data;
  data.truncate("image_0/000003.png");
  const Finished stopped = data.run();
  INFO(stopped.err);
  CHECK(stopped.exit_code == 5);
  CHECK(contains(stopped.err, "000003.png"));
  CHECK(readJson(data.out / "run.json")["counters"]["frames"] == 3);
  const Finished skipped = data.run({"--force", "--set", "on_findings=continue"});
  INFO(skipped.err);
  CHECK(skipped.exit_code == 0);
  CHECK(readJson(data.out / "run.json")["counters"]["defects"] == 1);
}

TEST_CASE("a failing start leaves an earlier run alone") {
  const Damaged data;
  REQUIRE(data.run().exit_code == 0);
  const std::string before = readText(data.out / "metrics.json");
  data.write("calib.txt", "");
  CHECK(data.run().exit_code == 8);
  CHECK(data.run({"--force"}).exit_code == 5);
  CHECK(data.run({"--force", "--set", "odometry.sped=1"}).exit_code == 3);
  CHECK(readText(data.out / "metrics.json") == before);
}

TEST_CASE("configurations that are wrong end with exit code 3 and all problems at once") {
  TemporaryFolder folder;
  const auto file = folder.path() / "bad.yaml";
  std::ofstream(file) << "name: bad\n"
                      << "source: {plugin: kitti, path: /nowhere, firts: 3}\n"
                      << "odometry: {plugin: steady, speed: fast}\n"
                      << "place: {plugin: view_templates, shift_step: 1, shift_step: 2}\n"
                      << "cells: {plugin: bayesian_atractor}\n"
                      << "map: {plugin: experience_map, on_failure: explode}\n"
                      << "observer: []\n";
  const auto finished = tolman::test::tolman(
      {"check", file.string(), "--plugin-path", inBuild("tests/fixtures/plugins/steady")});
  INFO(finished.err);
  CHECK(finished.exit_code == 3);
  CHECK(contains(finished.err, ":2:"));
  CHECK(contains(finished.err, "did you mean 'first'?"));
  CHECK(contains(finished.err, "odometry.speed"));
  CHECK(contains(finished.err, "place.shift_step: given twice"));
  CHECK(contains(finished.err, "did you mean 'bayesian_attractor'?"));
  CHECK(contains(finished.err, "map.on_failure"));
  CHECK(contains(finished.err, "did you mean 'observers'?"));
}
