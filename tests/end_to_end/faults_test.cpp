// SPDX-License-Identifier: BSD-3-Clause
// A full disk, for one file at a time: a run never succeeds if one of its files is incomplete.
#include <catch2/catch.hpp>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// A run whose writes to files with `file` in their path fail, after the first `after` of them.
struct FullDisk {
  TemporaryFolder folder;
  fs::path out = folder.path() / "run";

  FullDisk() { writeTinyKitti(folder.path() / "sequence", 12); }
  Finished run(const std::string& file, int after = 0,
               const std::vector<std::string>& more = {}) const {
    auto arguments = tinyRun(writeTinyConfig(folder.path(), folder.path() / "sequence"), out);
    const std::vector<std::string> environment = {
        "env", std::string("LD_PRELOAD=") + TOLMAN_FAILING_WRITES, "TOLMAN_FAIL_FILE=" + file,
        "TOLMAN_FAIL_AFTER=" + std::to_string(after), tolmanProgram().string()};
    arguments.insert(arguments.begin(), environment.begin(), environment.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return tolman::test::run(arguments);
  }
};

}  // namespace

TEST_CASE("a file of the run that cannot be written ends the run with exit code 8") {
  const std::string file = GENERATE(
      "/run/.config.resolved.yaml", "/run/run.sqlite", "/run/state/.map.bin",
      "/run/state/.session.json", "/run/.trajectory.tum", "/run/.map.g2o", "/run/.metrics.json",
      "/run/.map.svg", "/run/.results.sha256", "/run/figures/.", "/run/.report.html");
  const FullDisk disk;
  const Finished finished = disk.run(file);
  INFO(file << "\n" << finished.out << finished.err);
  CHECK(finished.exit_code == 8);
  CHECK(contains(finished.err, "full"));  // what to look for
  const auto run_file = nlohmann::json::parse(readText(disk.out / "run.json"), nullptr, false);
  if (!run_file.is_object()) return;  // none was written: nothing says success
  CHECK(run_file["status"] == "failed");
  CHECK(run_file["exit_code"] == 8);
  CHECK(run_file["failure"]["kind"] == "record");
}

TEST_CASE("a disk that fills up in the middle of the record ends the run with exit code 8") {
  const FullDisk disk;
  const int after = GENERATE(20, 50, 80);
  const Finished finished = disk.run("/run/run.sqlite", after);
  INFO(after << "\n" << finished.err);
  CHECK(finished.exit_code == 8);
  CHECK(readJson(disk.out / "run.json")["status"] == "failed");
}

TEST_CASE("a log that cannot be written ends the run with exit code 8") {
  const FullDisk disk;
  const Finished finished = disk.run(
      "/run/log.txt", 0, {"--set", "odometry={plugin: throws_in_track, on_failure: skip}"});
  INFO(finished.err);
  CHECK(finished.exit_code == 8);
  CHECK(contains(finished.err, "log.txt"));
  CHECK(readJson(disk.out / "run.json")["exit_code"] == 8);
}

TEST_CASE("a run.json that cannot be written at the end is no success") {
  const FullDisk disk;
  const Finished finished = disk.run("/run/.run.json", 1);  // the first says "running"
  INFO(finished.err);
  CHECK(finished.exit_code == 8);
  CHECK(contains(finished.err, "run.json: cannot be written; look for a full disk"));
}

TEST_CASE("a run that never tracked ends with exit code 6, and says so first") {
  const std::string odometry = GENERATE("feature_stereo", "direct_sparse_stereo");
  const auto [grey, hint] = GENERATE(table<int, std::string>(
      {{0, "the images are nearly black"}, {128, "left and right not exchanged?"}}));
  TemporaryFolder folder;
  const fs::path sequence = folder.path() / "sequence";
  writeTinyKitti(sequence, 8);
  for (const auto& image : fs::recursive_directory_iterator(sequence)) {
    if (image.path().extension() != ".png") continue;
    cv::imwrite(image.path().string(), cv::Mat(60, 160, CV_8UC1, cv::Scalar(grey)));
  }
  const fs::path config = folder.path() / "black.yaml";
  std::ofstream(config) << "source: {plugin: kitti, path: " << sequence.string() << "}\n"
                        << "odometry: {plugin: " << odometry << "}\n"
                        << "place: {plugin: view_templates}\n"
                        << "cells: {plugin: bayesian_attractor}\n"
                        << "map: {plugin: experience_map}\n";
  const fs::path out = folder.path() / "run";
  const Finished finished = tolman::test::tolman({"run", config.string(), "--out", out.string()});
  INFO(finished.out << finished.err);
  CHECK(finished.exit_code == 6);
  CHECK(finished.out.starts_with("verdict   the camera did not move, or no motion was found"));
  CHECK(contains(finished.out, "tracking  0 of 8 frames, 8 initialising, 0 lost"));
  CHECK(contains(finished.out, hint));
  CHECK(contains(finished.err, "no motion in the whole run"));
  const auto run_file = readJson(out / "run.json");
  CHECK(run_file["exit_code"] == 6);
  CHECK(contains(run_file["message"], "no motion in the whole run"));
  CHECK(run_file["counters"]["initialising"] == 8);
  CHECK(readJson(out / "metrics.json")["coverage"] == 0);
}

TEST_CASE(
    "the map of a run with a damaged record is refused with exit code 9, and leaves nothing") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 30);
  const fs::path config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const fs::path first = folder.path() / "first";
  const fs::path second = folder.path() / "second";
  REQUIRE(tolman::test::tolman(tinyRun(config, first)).exit_code == 0);
  REQUIRE(fs::exists(first / "state/session.json"));
  const auto size = fs::file_size(first / "run.sqlite");
  fs::resize_file(first / "run.sqlite", size / 2);
  fs::resize_file(first / "run.sqlite", size);  // the latter half is zero
  auto arguments = tinyRun(config, second);
  arguments.insert(arguments.end(), {"--continue", first.string()});
  const Finished finished = tolman::test::tolman(arguments);
  INFO(finished.err);
  CHECK(finished.exit_code == 9);
  CHECK(contains(finished.err, (first / "run.sqlite").string()));
  CHECK_FALSE(fs::exists(second));
}

TEST_CASE("export and report that cannot write end with exit code 8") {
  const FullDisk disk;
  REQUIRE(disk.run("nowhere").exit_code == 0);
  const auto to = [&](const char* command, const char* out) {
    return tolman::test::tolman({command, disk.out.string(), "--out", out});
  };
  CHECK(to("export", "/proc/nowhere").exit_code == 8);
  CHECK(to("report", "/proc/nowhere").exit_code == 8);
  CHECK(to("export", "").exit_code == 2);  // not the default
  CHECK(to("report", "").exit_code == 2);
  const Finished long_name = tolman::test::tolman({"report", std::string(5000, 'x')});
  INFO(long_name.err);
  CHECK(long_name.exit_code == 5);
}
