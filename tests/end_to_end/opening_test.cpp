// SPDX-License-Identifier: BSD-3-Clause
// Files that Tolman opens for inspection: plugins that crash, hang or pretend success, and pipes in
// place of files.
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

#include "end_to_end/fixture_plugins.hpp"
#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"
#include "tolman/context.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// Ends with 124 where `tolman` hangs.
Finished bounded(std::vector<std::string> words) {
  const std::vector<std::string> begin = {"timeout", "120", tolmanProgram().string()};
  words.insert(words.begin(), begin.begin(), begin.end());
  return run(words);
}

fs::path pipeAt(const fs::path& path) {
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  return path;
}

}  // namespace

TEST_CASE("plugins that crash, hang or pretend when they are opened are refused") {
  const std::string trap = GENERATE("abort", "exit", "hang");
  const std::string folder = kFixturePlugins + "dies_on_load";
  TemporaryFolder work;
  const std::string config = work.path() / "trap.yaml";
  std::ofstream(config) << "source: {plugin: kitti, path: .}\nodometry: {plugin: dies_on_load}\n"
                        << "place: {plugin: view_templates}\nmap: {plugin: experience_map}\n"
                        << "cells: {plugin: bayesian_attractor}\nisolation: {deadline: 15}\n";
  ::setenv("TOLMAN_TRAP", trap.c_str(), 1);
  const auto refused = [&](const std::vector<std::string>& words) {
    const Finished finished = bounded(words);
    CAPTURE(trap, words, finished.out, finished.err);
    CHECK(finished.exit_code == 4);
    CHECK(contains(finished.err, "plugin/died"));
  };
  const Finished examined =
      bounded({"plugins", "doctor", folder + "/tolman_odometry_dies_on_load.so"});
  CAPTURE(trap, examined.out, examined.err);
  CHECK(examined.exit_code == 4);
  CHECK(contains(examined.out, " in 'load'"));
  refused({"plugins", "describe", "dies_on_load", "--plugin-path", folder});
  refused({"check", config, "--plugin-path", folder});
  ::unsetenv("TOLMAN_TRAP");
}

TEST_CASE("damaged libraries are refused or work; they never end the doctor") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "mutant.so";
  const std::string sound = readText(kFixturePlugins + "steady/tolman_odometry_steady.so");
  tolman::RandomStream random(17);
  int refused = 0;
  for (int mutant = 0; mutant < 10; ++mutant) {
    std::string bytes = sound;
    for (int i = 0; i < 200; ++i) {
      bytes[64 + random.below(bytes.size() - 64)] = static_cast<char>(random.below(256));
    }
    std::ofstream(file, std::ios::binary) << bytes;
    const Finished finished = bounded({"plugins", "doctor", file.string()});
    CAPTURE(mutant, finished.out, finished.err);
    CHECK((finished.exit_code == 0 || finished.exit_code == 4));
    CHECK((finished.exit_code == 0) == contains(finished.out, "ok       life-unused "));
    CHECK((finished.exit_code == 4) == contains(finished.out, "error    "));
    refused += finished.exit_code == 4 ? 1 : 0;
  }
  CHECK(refused > 0);
}

TEST_CASE("a pipe in place of a file is refused, not waited for") {
  const TemporaryFolder folder;
  const std::string pipe = pipeAt(folder.path() / "pipe.so").string();
  CHECK(bounded({"plugins", "doctor", pipe}).exit_code == 4);
  CHECK(contains(bounded({"plugins", "list", "--plugin-path", folder.path().string()}).out,
                 "plugin/unreadable"));
  CHECK(bounded({"eval", pipe, pipe}).exit_code == 5);
  CHECK(bounded({"check", pipe}).exit_code == 3);
  pipeAt(folder.path() / "odometry.g2o");
  const Finished log =
      bounded({"dataset", "check", folder.path().string(), "--source", "motion_log"});
  INFO(log.out << log.err);
  CHECK(log.exit_code == 5);
}

TEST_CASE("rerun tells what it did, as run does") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 6);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const std::string run = (folder.path() / "run").string();
  REQUIRE(tolman::test::tolman(tinyRun(config, run)).exit_code == 0);
  const Finished again =
      bounded({"rerun", run, "--plugin-path", kFixturePlugins + "steady", "--quiet"});
  CHECK(again.exit_code == 0);
  CHECK(again.out.empty());
  const Finished told =
      bounded({"rerun", run, "--force", "--plugin-path", kFixturePlugins + "steady"});
  CAPTURE(told.out, told.err);
  CHECK(contains(told.out, "5 of 6 frames, 1 initialising"));
  CHECK(contains(told.out, "run-again/report.html"));
}

TEST_CASE("an output that is a pipe or a device is written to, and stays what it is") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 6);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const std::string run_folder = (folder.path() / "run").string();
  REQUIRE(tolman::test::tolman(tinyRun(config, run_folder)).exit_code == 0);
  const std::string table = bounded({"compare", run_folder}).out;
  REQUIRE(!table.empty());
  const fs::path pipe = pipeAt(folder.path() / "pipe");
  const Finished unread = bounded({"compare", run_folder, "--out", pipe.string()});
  CHECK(unread.exit_code == 8);
  CHECK(contains(unread.err, "pipe: nobody reads this pipe; start its reader first"));
  CHECK(fs::is_fifo(pipe));
  const auto shell = [&](const std::string& line) {
    return run({"timeout", "60", "sh", "-c", line, "sh", tolmanProgram().string(), run_folder,
                pipe.string()});
  };
  CHECK(shell("cat \"$3\" & sleep 0.2; \"$1\" -q compare \"$2\" --out \"$3\" && wait").out ==
        table);
  CHECK(fs::is_fifo(pipe));
  // Through a link of this test: the program must not replace /dev/stdout if it is wrong.
  fs::create_symlink("/proc/self/fd/1", folder.path() / "stdout");
  fs::remove(pipe);
  fs::create_symlink("/dev/null", pipe);
  const std::string link = (folder.path() / "stdout").string();
  CHECK(bounded({"compare", run_folder, "--out", link}).out == table);
  CHECK(fs::is_symlink(link));
  CHECK(bounded({"compare", run_folder, "--out", pipe.string()}).exit_code == 0);
  CHECK(fs::is_symlink(pipe));
  const Finished full =
      shell("ln -s /dev/full \"$3.full\"; \"$1\" compare \"$2\" --out \"$3.full\"");
  CHECK(full.exit_code == 8);
}

TEST_CASE("JSON is UTF-8 whatever the names of files are") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 6);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const std::string one = (folder.path() / "a\xff").string();
  const std::string two = (folder.path() / "b\xfe").string();
  for (const std::string& out : {one, two}) {
    auto words = tinyRun(config, out);
    words.insert(words.end(), {"--set", "record.replay=true", "--json"});
    const Finished finished = bounded(words);
    CAPTURE(finished.err);
    CHECK(finished.exit_code == 0);
    CHECK(contains(finished.out, "\xef\xbf\xbd"));
    CHECK_FALSE(nlohmann::json::parse(finished.out, nullptr, false).is_discarded());
  }
  const auto valid = [&](std::vector<std::string> words) {
    words.emplace_back("--json");
    const Finished finished = bounded(words);
    CAPTURE(words, finished.out, finished.err);
    CHECK(finished.exit_code == 0);
    CHECK_FALSE(nlohmann::json::parse(finished.out, nullptr, false).is_discarded());
  };
  valid({"compare", one, two, "--metric", "map.coverage"});
  valid({"export", one});
  // A stage that saves its state has a path among its parameters.
  auto words = tinyRun(config, folder.path() / "next");
  words.insert(words.end(), {"--set", "place.plugin=place_replay", "--set", "place.record=" + one});
  valid(words);
}
