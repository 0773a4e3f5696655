// SPDX-License-Identifier: BSD-3-Clause
// Interrupted and killed runs: their records can be read and exported.
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <memory>
#include <thread>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// A realtime run of 8 s of data that a test may disturb.
struct LongRun {
  TemporaryFolder folder;
  fs::path out = folder.path() / "run";
  std::unique_ptr<Process> process;

  LongRun() {
    writeTinyKitti(folder.path() / "sequence", 80);
    const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
    auto arguments = tinyRun(config, out);
    arguments.insert(arguments.begin(), tolmanProgram().string());
    for (const char* word : {"--set", "pipeline.mode=realtime"}) arguments.emplace_back(word);
    process = std::make_unique<Process>(arguments, folder.path());
  }
  /// Waits until the record is there, then `more`.
  void waitInside(std::chrono::milliseconds more) const {
    for (int i = 0; i < 2000 && !fs::exists(out / "run.sqlite"); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::this_thread::sleep_for(more);
  }
};

int lines(const fs::path& file) {
  const std::string text = readText(file);
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("a signal that asks for an end finishes the files and exits with 130") {
  const int signal = GENERATE(SIGINT, SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM, SIGXCPU);
  const LongRun run;
  run.waitInside(std::chrono::milliseconds(1000));
  run.process->signal(signal);
  if (signal != SIGINT) run.process->signal(signal);  // the second one has no effect
  const Finished finished = run.process->wait();
  INFO(finished.err);
  CHECK(finished.exit_code == 130);
  const auto provenance = readJson(run.out / "run.json");
  CHECK(provenance["status"] == "interrupted");
  const int frames = provenance["counters"]["frames"];
  CHECK(frames > 0);
  CHECK(frames < 80);
  CHECK(lines(run.out / "trajectory.tum") == frames);
  CHECK(readJson(run.out / "metrics.json")["odometry"]["poses"] == frames);
}

TEST_CASE("a second signal ends a run at once") {
  const int signal = GENERATE(SIGINT, SIGTERM);
  const LongRun run;
  run.waitInside(std::chrono::milliseconds(1000));
  run.process->signal(signal);
  run.process->signal(signal);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));  // if the two were taken as one
  run.process->signal(signal);
  const Finished finished = run.process->wait();
  INFO(finished.err);
  CHECK(finished.exit_code == 128 + signal);
}

TEST_CASE("SIGKILL at different moments loses at most the last second") {
  const auto delay = std::chrono::milliseconds(GENERATE(1200, 2150, 3700));
  const LongRun run;
  run.waitInside(delay);
  run.process->signal(SIGKILL);
  CHECK(run.process->wait().exit_code == 128 + SIGKILL);
  CHECK(readJson(run.out / "run.json")["status"] == "running");

  const Finished exported = tolman::test::tolman({"export", run.out.string()});
  INFO(exported.err);
  REQUIRE(exported.exit_code == 0);
  const int frames = lines(run.out / "trajectory.tum");
  CHECK(frames > 0);
  CHECK(lines(run.out / "odometry.tum") == frames);
  CHECK(contains(readText(run.out / "map.g2o"), "VERTEX_SE3:QUAT 0"));
}

TEST_CASE("a signal while a source is configured ends a command as one during the run does") {
  const TemporaryFolder folder;
  const fs::path begun = folder.path() / "begun";
  const fs::path config = folder.path() / "slow.yaml";
  const fs::path out = folder.path() / "written";
  std::ofstream(config) << "source: {plugin: slow_start, begun: " << begun << "}\n"
                        << "odometry: {plugin: steady}\nplace: {plugin: view_templates}\n"
                        << "cells: {plugin: pose_cells}\nmap: {plugin: relaxation}\n";
  const std::vector<std::string> command =
      GENERATE(std::vector<std::string>{"run"}, std::vector<std::string>{"dataset", "render"});
  for (const int number : {SIGINT, SIGTERM}) {
    fs::remove(begun);
    std::vector<std::string> words = {tolmanProgram().string()};
    words.insert(words.end(), command.begin(), command.end());
    words.insert(words.end(), {config.string(), "--out", out.string()});
    for (const char* plugins : {"slow_start", "steady"}) {
      words.insert(words.end(),
                   {"--plugin-path", inBuild(std::string("tests/fixtures/plugins/") + plugins)});
    }
    Process process(words, folder.path());
    for (int i = 0; i < 2000 && !fs::exists(begun); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    process.signal(number);
    const Finished finished = process.wait();
    INFO(finished.err);
    CHECK(finished.exit_code == 130);
    CHECK(contains(finished.err, "interrupted while it was configured"));
    CHECK_FALSE(contains(finished.err, "no camera came"));
    CHECK_FALSE(fs::exists(out));
  }
}
