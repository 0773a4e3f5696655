// SPDX-License-Identifier: BSD-3-Clause
// A run on the recorded answers of another one has the same results, byte for byte.
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "end_to_end/process.hpp"
#include "end_to_end/record_rows.hpp"
#include "experiment/motion_folder.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

struct Recorded {
  TemporaryFolder folder;

  Recorded() {
    writeMotionFolder(folder.path() / "log");
    writeMotionConfig(folder.path(), folder.path() / "log");
    std::ofstream(folder.path() / "again.yaml")
        << "extends: motion.yaml\nname: motion\n"
           "source: {plugin: record, path: run}\n"
           "odometry: {plugin: motion_replay, record: run}\n"
           "place: {plugin: place_replay, record: run}\n";
  }
  Words words(const std::string& config, const std::string& out, const Words& settings) const {
    Words words = {"run", (folder.path() / config).string(), "--quiet", "--out",
                   (folder.path() / out).string()};
    for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
    return words;
  }
  Finished run(const std::string& config, const std::string& out, const Words& settings = {}) {
    return tolman::test::tolman(words(config, out, settings));
  }
  std::string text(const std::string& file) const { return readText(folder.path() / file); }
  /// What a later run replays of this one, bit for bit.
  std::string answers(const std::string& run) const {
    std::string text;
    for (const char* columns :
         {"frame, stamp_ns, source_index, has_truth, defect FROM frame",
          "frame, state, dt, hex(covariance), v, omega, tracked, points_frame, hex(points) FROM "
          "motion",
          "announced_at, frame, hex(covariance) FROM motion_revision",
          "frame, recognition, template_id, score, relative_yaw, has_relative_pose, "
          "hex(covariance) FROM place",
          "frame, name, shape, hex(\"values\") FROM array WHERE source = 'sensors'",
          "frame, of, hex(poses) FROM exact_pose"}) {
      text += recordText(folder.path() / run, std::string("SELECT ") + columns);
    }
    REQUIRE(text.size() > 10000);
    return text;
  }
};

// Noise, lost frames and false matches: all kinds of answers.
const Words kFrontEnd = {"odometry.noise_distance=0.03", "odometry.noise_heading=0.003",
                         "odometry.lost=0.05", "place.invented=0.1", "seed=7"};

Words recording() {
  Words settings = kFrontEnd;
  settings.emplace_back("record.replay=true");
  return settings;
}

}  // namespace

TEST_CASE("cells and map on recorded answers give the same bytes as with the front end") {
  Recorded data;
  REQUIRE(data.run("motion.yaml", "run", recording()).exit_code == 0);
  const Finished again = data.run("again.yaml", "again", {"seed=7"});
  INFO(again.err);
  REQUIRE(again.exit_code == 0);
  CHECK(data.text("again/results.sha256") == data.text("run/results.sha256"));
  auto first = readJson(data.folder.path() / "run/metrics.json");
  auto second = readJson(data.folder.path() / "again/metrics.json");
  first.erase("timing");
  second.erase("timing");
  CHECK(first == second);
  CHECK(first["loop_decisions"] > 0);

  // Other cells: the same as other cells with the front end.
  Words other = kFrontEnd;
  other.emplace_back("cells.loop_spacing=0");
  REQUIRE(data.run("motion.yaml", "other", other).exit_code == 0);
  REQUIRE(data.run("again.yaml", "other-again", {"seed=7", "cells.loop_spacing=0"}).exit_code == 0);
  CHECK(data.text("other-again/results.sha256") == data.text("other/results.sha256"));
  CHECK(data.text("other/results.sha256") != data.text("run/results.sha256"));

  // A replay can be recorded and replayed as well.
  REQUIRE(data.run("again.yaml", "copy", {"seed=7", "record.replay=true"}).exit_code == 0);
  CHECK(data.answers("copy") == data.answers("run"));
}

TEST_CASE("the body of the truth is taken off once, not again in a replay") {
  Recorded data;
  const std::string body = "evaluation.body=0.2,0,-1.5";
  Words settings = recording();
  settings.push_back(body);
  REQUIRE(data.run("motion.yaml", "run", settings).exit_code == 0);
  const Finished again = data.run("again.yaml", "again", {"seed=7", body});
  INFO(again.err);
  REQUIRE(again.exit_code == 0);
  CHECK(data.text("again/results.sha256") == data.text("run/results.sha256"));
}

TEST_CASE("noise on recorded motion is drawn from the seed") {
  Recorded data;
  REQUIRE(data.run("motion.yaml", "run", {"record.replay=true"}).exit_code == 0);
  const Words noise = {"odometry.noise_distance=0.05", "odometry.noise_heading=0.002"};
  for (const char* seed : {"1", "2"}) {
    Words settings = noise;
    settings.push_back(std::string("seed=") + seed);
    REQUIRE(data.run("again.yaml", seed, settings).exit_code == 0);
    REQUIRE(data.run("again.yaml", std::string("again-") + seed, settings).exit_code == 0);
    CHECK(data.text(std::string(seed) + "/results.sha256") ==
          data.text(std::string("again-") + seed + "/results.sha256"));
  }
  CHECK(data.text("1/odometry.tum") != data.text("2/odometry.tum"));
  CHECK(data.text("1/odometry.tum") != data.text("run/odometry.tum"));
}

TEST_CASE("a run that was killed and resumed has the same answers as one without interruption") {
  Recorded data;
  Words settings = recording();
  for (const char* paced : {"pipeline.mode=realtime", "pipeline.speed=20",
                            "pipeline.input_policy=block", "record.state_every=0.05"}) {
    settings.emplace_back(paced);
  }
  REQUIRE(data.run("motion.yaml", "whole", recording()).exit_code == 0);
  const fs::path out = data.folder.path() / "run";
  Words command = data.words("motion.yaml", "run", settings);
  command.insert(command.begin(), tolmanProgram().string());
  Process process(command, data.folder.path());
  for (int i = 0; i < 3000 && !fs::exists(out / "state/checkpoint.json"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  process.signal(SIGKILL);
  CHECK(process.wait().exit_code == 128 + SIGKILL);

  const Finished early = data.run("again.yaml", "early");
  CHECK(early.exit_code == 5);
  CHECK(contains(early.err, "the run has not ended"));

  REQUIRE(tolman::test::tolman({"run", "--resume", out.string(), "--quiet"}).exit_code == 0);
  CHECK(data.answers("run") == data.answers("whole"));
}

TEST_CASE("what cannot be replayed is told with its remedy") {
  Recorded data;
  REQUIRE(data.run("motion.yaml", "run").exit_code == 0);
  const Finished without = data.run("again.yaml", "again");
  CHECK(without.exit_code == 5);
  CHECK(contains(without.err, "run.sqlite: has no exact poses; record the run with"));

  fs::remove_all(data.folder.path() / "run");
  REQUIRE(data.run("motion.yaml", "run", {"record.replay=true"}).exit_code == 0);
  const Finished wrong = data.run("again.yaml", "again", {"odometry.lost=0.1"});
  CHECK(wrong.exit_code == 3);
  CHECK(contains(wrong.err, "lost and carried_at need the motion of the source"));
}

TEST_CASE("a run that is made again gives the same bytes, or the files that differ are listed") {
  Recorded data;
  REQUIRE(data.run("motion.yaml", "run", kFrontEnd).exit_code == 0);
  const std::string run = (data.folder.path() / "run").string();
  const Finished same = tolman::test::tolman({"rerun", run, "--verify"});
  INFO(same.err);
  CHECK(same.exit_code == 0);
  CHECK(contains(same.out, "trajectory.tum      same\n"));
  const auto json = readJson(data.folder.path() / "run/run.json");
  CHECK(json["data"][0]["files"] == 3);
  CHECK(json["data"][0]["sha256"].get<std::string>().size() == 64);
  CHECK(json["libraries"].contains("sqlite"));
  CHECK(json["libraries"].contains("opencv"));

  const fs::path digests = data.folder.path() / "run/results.sha256";
  const std::string listed = readText(digests);
  std::ofstream(digests) << listed.substr(0, listed.find('\n') + 1);
  const Finished cut = tolman::test::tolman({"rerun", run, "--verify", "--force"});
  CHECK(cut.exit_code == 8);
  CHECK(contains(cut.out, "is in one of the runs only\n"));
  std::ofstream(digests) << listed;

  writeMotionFolder(data.folder.path() / "log", 0.004);
  const Finished other = tolman::test::tolman({"rerun", run, "--verify", "--force"});
  CHECK(other.exit_code == 8);
  CHECK(contains(other.out, "trajectory.tum      differs\n"));
  const Finished quiet = tolman::test::tolman({"-q", "rerun", run, "--verify", "--force"});
  CHECK(quiet.exit_code == 8);
  CHECK(contains(quiet.err, "run-again: its results are not those of "));
}
