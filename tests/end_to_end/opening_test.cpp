// SPDX-License-Identifier: BSD-3-Clause
// Files that Tolman opens for inspection: plugins that crash, hang or pretend success, and pipes in
// place of files.
#include <sys/stat.h>

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
  refused({"plugins", "doctor", folder + "/tolman_odometry_dies_on_load.so"});
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
  for (int mutant = 0; mutant < 40; ++mutant) {
    std::string bytes = sound;
    for (int i = 0; i < 200; ++i) {
      bytes[64 + random.below(bytes.size() - 64)] = static_cast<char>(random.below(256));
    }
    std::ofstream(file, std::ios::binary) << bytes;
    const Finished finished = bounded({"plugins", "doctor", file.string()});
    CAPTURE(mutant, finished.out, finished.err);
    CHECK((finished.exit_code == 0 || finished.exit_code == 4));
    CHECK((finished.exit_code == 0) == contains(finished.out, "construct  made and destroyed"));
    CHECK((finished.exit_code == 4) == contains(finished.err, "plugin/"));
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

TEST_CASE("init does not wait for pipes in the folder of a recording") {
  const TemporaryFolder folder;
  const fs::path sequence = folder.path() / "sequence";
  writeTinyKitti(sequence, 3);
  pipeAt(sequence / "extra.txt");
  CHECK(bounded({"init", sequence.string()}).exit_code == 0);
  fs::remove(sequence / "times.txt");
  pipeAt(sequence / "times.txt");
  CHECK(bounded({"init", sequence.string()}).exit_code != 124);
}

TEST_CASE("a path that cannot be followed is no internal error") {
  const TemporaryFolder folder;
  const fs::path loop = folder.path() / "loop";
  fs::create_symlink(loop, loop);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"compare"}, {"rerun"}, {"sweep", "collect"}}) {
    std::vector<std::string> command = words;
    command.push_back(loop.string());
    const Finished finished = bounded(command);
    CAPTURE(command, finished.err);
    CHECK(finished.exit_code == 5);
    CHECK(contains(finished.err, "Too many levels of symbolic links"));
  }
}

TEST_CASE("a damaged run.json is told by report, export and compare") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 6);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const std::string run = (folder.path() / "run").string();
  REQUIRE(tolman::test::tolman(tinyRun(config, run)).exit_code == 0);
  std::ofstream(folder.path() / "run/run.json") << "x";
  const std::string told = "run.json: is missing or damaged";
  CHECK(contains(bounded({"report", run}).err, told));
  CHECK(contains(bounded({"export", run}).err, told));
  const Finished compared = bounded({"compare", run});
  CHECK(compared.exit_code == 5);
  CHECK(contains(compared.err, told));
}
