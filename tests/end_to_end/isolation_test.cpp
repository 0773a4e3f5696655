// SPDX-License-Identifier: BSD-3-Clause
// Stages in separate processes: the same results, and their crashes do not end the host.
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "end_to_end/fixture_plugins.hpp"
#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> isolated(const std::vector<std::string>& stages) {
  std::vector<std::string> arguments;
  for (const std::string& stage : stages) {
    arguments.insert(arguments.end(), {"--set", stage + ".isolation=process"});
  }
  return arguments;
}

/// Runs a tiny sequence with one stage taken from the fixture library `library`.
struct Attempt {
  TemporaryFolder folder;
  fs::path out = folder.path() / "run";
  Finished finished;

  Attempt(const std::string& library, const std::string& stage, const std::string& plugin,
          const std::string& more = "", int frames = 6) {
    writeTinyKitti(folder.path() / "sequence", frames);
    const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
    const std::string value = "{plugin: " + plugin + ", isolation: process" + more + "}";
    finished = tolman::test::tolman(
        {"run", config.string(), "--out", out.string(), "--plugin-path", kFixturePlugins + library,
         "--plugin-path", kFixturePlugins + "steady", "--set",
         stage == "observers" ? "observers=[" + value + "]" : stage + "=" + value, "--set",
         "isolation.deadline=3", "--set", "isolation.memory_limit=1024"});
  }
  nlohmann::json provenance() const { return readJson(out / "run.json"); }
};

struct Guest {
  const char* library;
  const char* stage;
  const char* plugin;
  int exit_code;  ///< 0: a fault that does not show in a short run
};

}  // namespace

TEST_CASE("results are the same, byte for byte, wherever the stages run") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 12);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const auto here = folder.path() / "here";
  const auto there = folder.path() / "there";
  REQUIRE(tolman::test::tolman(tinyRun(config, here)).exit_code == 0);
  auto arguments = tinyRun(config, there);
  for (const auto& word : isolated({"source", "odometry", "place", "cells", "map"})) {
    arguments.push_back(word);
  }
  const Finished finished = tolman::test::tolman(arguments);
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  CHECK(readText(here / "results.sha256") == readText(there / "results.sha256"));
}

TEST_CASE("a crash ends the run as a failing plugin does, and what was recorded stays") {
  const Attempt attempt("process_faults", "odometry", "segfault");
  CHECK(attempt.finished.exit_code == 7);
  CHECK(contains(attempt.finished.err,
                 "odometry (segfault), track, frame 3: its process died of SIGSEGV"));
  CHECK(attempt.provenance()["counters"]["frames"] == 3);
  CHECK(fs::exists(attempt.out / "trajectory.tum"));
}

namespace {}  // namespace

TEST_CASE("on_failure: skip goes on without the stage") {
  const Attempt attempt("process_faults", "odometry", "segfault", ", on_failure: skip");
  INFO(attempt.finished.err);
  CHECK(attempt.finished.exit_code == 6);  // lost from frame 3 to the end
  CHECK(attempt.provenance()["counters"]["frames"] == 6);
  CHECK(attempt.provenance()["counters"]["skipped"] >= 3);
}

TEST_CASE("on_failure: restart loses one frame") {
  const Attempt attempt("process_faults", "odometry", "segfault", ", on_failure: restart");
  INFO(attempt.finished.err);
  CHECK(attempt.finished.exit_code == 0);
  CHECK(attempt.provenance()["counters"]["frames"] == 6);
  CHECK(attempt.provenance()["counters"]["skipped"] == 1);
  CHECK(contains(readText(attempt.out / "log.txt"), "a new process was started (restart 1 of 10)"));
}

TEST_CASE("a stage that hangs or eats memory is ended at its bounds") {
  const Attempt hangs("process_faults", "odometry", "loop_forever");
  CHECK(hangs.finished.exit_code == 7);
  CHECK(contains(hangs.finished.err, "frame 3: its process did not return within 3 s"));
  const Attempt eats("process_faults", "odometry", "eat_memory");
  CHECK(eats.finished.exit_code == 7);
  CHECK(contains(eats.finished.err, "isolation.memory_limit is 1024 MiB"));
}

TEST_CASE("an observer learns the time of every stage and what went wrong, wherever it runs") {
  for (const std::string isolation : {"none", "process"}) {
    TemporaryFolder folder;
    writeTinyKitti(folder.path() / "sequence", 6);
    const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
    auto arguments = tinyRun(config, folder.path() / "run");
    for (const std::string& word : std::vector<std::string>{
             "--plugin-path", kFixturePlugins + "snapshot_log", "--plugin-path",
             kFixturePlugins + "misbehaving", "--plugin-path", kFixturePlugins + "steady", "--set",
             "odometry={plugin: throws_in_track, on_failure: skip}", "--set",
             "observers=[{plugin: snapshot_log, isolation: " + isolation + "}]"}) {
      arguments.push_back(word);
    }
    const Finished finished = tolman::test::tolman(arguments);
    INFO(finished.err);
    const std::string told =
        readText(folder.path() / "run" / "artefacts" / "snapshot_log" / "snapshots.txt");
    INFO(told);
    CHECK(contains(told, "timed\n"));
    CHECK(contains(told, "3 warning odometry: "));
    CHECK(contains(told, "frame skipped"));
  }
}

TEST_CASE("restart is refused where it cannot work") {
  const Attempt in_host("misbehaving", "odometry", "throws_in_track",
                        ", isolation: none, on_failure: restart");
  CHECK(in_host.finished.exit_code == 3);
  const Attempt forgetful("role_faults", "place", "skips_template_ids", ", on_failure: restart");
  CHECK(forgetful.finished.exit_code == 3);
  CHECK(contains(forgetful.finished.err, "place.on_failure: plugin 'skips_template_ids' cannot"));
}

TEST_CASE("no broken plugin brings down the host") {
  const std::vector<Guest> corpus = {
      {"dies_on_load", "odometry", "dies_on_load", 4},
      {"missing_symbol", "odometry", "missing_symbol", 4},
      {"entry_missing", "odometry", "entry_missing", 4},
      {"returns_null", "odometry", "returns_null", 4},
      {"avx2", "odometry", "steady", 4},
      {"process_faults", "odometry", "segfault", 7},
      {"process_faults", "odometry", "abort_", 7},
      {"process_faults", "odometry", "exit_", 7},
      {"process_faults", "odometry", "terminate", 7},
      {"process_faults", "odometry", "divide_by_zero", 7},
      {"process_faults", "odometry", "recurse_forever", 7},
      {"process_faults", "odometry", "write_to_stdout", 0},
      {"process_faults", "odometry", "install_handler", 0},
      {"process_faults", "odometry", "change_locale", 0},
      {"process_faults", "odometry", "change_folder", 0},
      {"process_faults", "odometry", "leak_thread", 0},
      {"process_faults", "odometry", "leak_memory", 0},
      {"process_faults", "odometry", "run_on", 0},
      {"misbehaving", "odometry", "throws_in_constructor", 4},
      {"misbehaving", "odometry", "throws_in_configure", 4},
      {"misbehaving", "odometry", "throws_in_track", 7},
      {"misbehaving", "odometry", "throws_in_destructor", 0},
      {"misbehaving", "odometry", "returns_nan", 7},
      {"misbehaving", "odometry", "goes_back_in_time", 7},
      {"answer_faults", "odometry", "crashes_on_empty", 0},
      {"answer_faults", "odometry", "destructor_needs_configure", 0},
      {"answer_faults", "odometry", "finish_needs_frames", 0},
      {"role_faults", "place", "crashes_on_damage", 0},
      {"role_faults", "cells", "stays_elsewhere", 0},
      {"role_faults", "map", "counts_more", 7},
      {"role_faults", "observers", "watches_null_graph", 7},
      {"role_faults", "source", "promises_more, path: nowhere", 0},
  };
  for (const Guest& guest : corpus) {
    const Attempt attempt(guest.library, guest.stage, guest.plugin, "", 5);
    INFO(guest.library << ", " << guest.plugin << ": " << attempt.finished.err);
    CHECK(attempt.finished.exit_code == guest.exit_code);
    CHECK((guest.exit_code == 0 || contains(attempt.finished.err, guest.plugin)));
  }
}

TEST_CASE("a source that gives fewer frames than it had announced is a warning") {
  const Attempt attempt("role_faults", "source", "promises_more, path: nowhere", "", 5);
  INFO(attempt.finished.err);
  CHECK(attempt.finished.exit_code == 0);
  CHECK(contains(attempt.finished.err, "gave 5 frames, and had announced 9"));
}

TEST_CASE("standard output stays the host's: a plugin that prints does not spoil --json") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 5);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const Finished finished =
      tolman::test::tolman({"run", config.string(), "--out", (folder.path() / "run").string(),
                            "--json", "--plugin-path", kFixturePlugins + "process_faults", "--set",
                            "odometry={plugin: write_to_stdout, isolation: process}"});
  CHECK(finished.exit_code == 0);
  CHECK(nlohmann::json::parse(finished.out)["exit_code"] == 0);
}

TEST_CASE("when the host is killed its stages do not live on") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 5);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  // The folder in the command's environment marks the processes that belong to this test.
  const std::string mark = folder.path().string();
  Process host(
      {"/usr/bin/env", "TOLMAN_TEST_MARK=" + mark, tolmanProgram().string(), "run", config.string(),
       "--out", (folder.path() / "run").string(), "--plugin-path",
       kFixturePlugins + "process_faults", "--set",
       "odometry={plugin: loop_forever, isolation: process}", "--set", "isolation.deadline=0"},
      folder.path());
  const auto marked = [&] {
    int count = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
      std::ifstream environment(entry.path() / "environ", std::ios::binary);
      const std::string text(std::istreambuf_iterator<char>(environment), {});
      if (contains(text, mark)) ++count;
    }
    return count;
  };
  const auto wait = [&](int wanted) {
    for (int i = 0; i < 3000 && marked() != wanted; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  };
  // Before the run begins, processes that look at the plugins come and go.
  for (int i = 0; i < 3000 && !fs::exists(folder.path() / "run" / "run.sqlite"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  wait(2);
  REQUIRE(marked() == 2);
  host.signal(SIGKILL);
  (void)host.wait();
  wait(0);
  CHECK(marked() == 0);
}
