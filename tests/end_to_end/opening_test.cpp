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

TEST_CASE("a damaged or missing run.json is told by every command that can do without it") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 6);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const std::string run = (folder.path() / "run").string();
  REQUIRE(tolman::test::tolman(tinyRun(config, run)).exit_code == 0);
  if (GENERATE(true, false)) {
    std::ofstream(folder.path() / "run/run.json") << "x";
  } else {
    fs::remove(folder.path() / "run/run.json");
  }
  const std::string told = "run.json: is missing or damaged";
  const auto tells = [&](std::vector<std::string> words) {
    const auto fixtures = tinyRun(config, folder.path() / "next");
    if (words.front() == "rerun") {
      words.insert(words.end(), std::find(fixtures.begin(), fixtures.end(), "--plugin-path"),
                   std::find(fixtures.begin(), fixtures.end(), "--plugin-path") + 2);
    }
    const Finished finished = bounded(words);
    CAPTURE(words, finished.out, finished.err);
    CHECK(finished.exit_code == 0);
    CHECK(contains(finished.err, told));
    return finished.out;
  };
  tells({"report", run});
  tells({"export", run});
  tells({"plan", run, "--from", "0", "--to", "here"});
  tells({"rerun", run});
  CHECK(contains(tells({"rerun", run, "--force", "--verify"}),
                 "not known: the earlier run.json is missing or damaged"));
  auto next = tinyRun(config, folder.path() / "next");
  next.insert(next.end(), {"--continue", run});
  const Finished continued = bounded(next);  // could be the map of another run
  CHECK(continued.exit_code == 9);
  CHECK(contains(continued.err, told));
  CHECK(contains(continued.err, "put it back, or run the earlier session again"));
  const Finished compared = bounded({"compare", run});
  CHECK(compared.exit_code == (fs::exists(folder.path() / "run/run.json") ? 5 : 0));
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

TEST_CASE("a folder that this user may not enter is denied, not missing") {
  const TemporaryFolder folder;
  const fs::path locked = folder.path() / "locked";
  fs::create_directory(locked);
  fs::permissions(locked, fs::perms::none);
  std::vector<std::string> as_other;  // root may enter any folder
  if (::geteuid() == 0) {
    fs::permissions(folder.path(), fs::perms::all);
    as_other = {"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"};
    auto reachable = as_other;
    reachable.insert(reachable.end(), {"test", "-x", tolmanProgram().string()});
    if (run(reachable).exit_code != 0) return;  // the build lies in a folder of its owner
  }
  const auto denied = [&](const std::vector<std::string>& words, int exit_code) {
    auto command = as_other;
    command.insert(command.end(), {"timeout", "60", tolmanProgram().string()});
    command.insert(command.end(), words.begin(), words.end());
    const Finished finished = run(command);
    CAPTURE(words, finished.out, finished.err);
    CHECK(finished.exit_code == exit_code);
    CHECK((contains(finished.err, "ermission denied") ||
           contains(finished.out, "permission denied")));
  };
  const std::string inside = (locked / "x").string();
  for (const char* command : {"report", "export", "compare", "rerun", "view"}) {
    denied({command, inside}, 5);
  }
  denied({"plan", inside, "--from", "0", "--to", "1"}, 5);
  denied({"eval", inside, inside}, 5);
  denied({"init", inside}, 5);
  denied({"run", "--resume", inside}, 9);
  denied({"check", inside + ".yaml"}, 3);
  denied({"check", "kitti", "--set", "source.path=" + inside}, 3);
  denied({"dataset", "check", inside}, 3);
  denied({"sweep", inside + ".yaml"}, 3);
  denied({"sweep", "status", inside}, 2);
  denied({"sweep", "point", locked.string()}, 3);
  denied({"plugins", "list", "--plugin-path", inside}, 2);
  fs::permissions(locked, fs::perms::owner_all);
}

TEST_CASE("the point of a sweep whose folder cannot be read ends, instead of waiting for it") {
  if (::geteuid() != 0) return;  // the folder's owner could read it
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms(0711));
  std::ofstream(folder.path() / "point.json") << "{}";
  const Finished finished =
      run({"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "timeout", "20",
           tolmanProgram().string(), "sweep", "point", folder.path().string()});
  CHECK(finished.exit_code != 124);
}

TEST_CASE("--plugin-path takes folders and libraries, nothing else") {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "notes.txt";
  std::ofstream(file) << "x\n";
  const Finished finished = bounded({"plugins", "list", "--plugin-path", file});
  CHECK(finished.exit_code == 2);
  CHECK(contains(finished.err, "notes.txt is not an ELF file"));
  CHECK(contains(finished.err, "remedy:"));
  const std::string steady = kFixturePlugins + "steady/tolman_odometry_steady.so";
  CHECK(contains(bounded({"plugins", "list", "--plugin-path", steady}).out, "steady"));
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
