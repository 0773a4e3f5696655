// SPDX-License-Identifier: BSD-3-Clause
// Too little memory: one clear message and the exit code of the table, never a signal.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <set>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// `tolman` with these arguments and at most `mib` of address space, after a command of the shell.
Finished within(int mib, const std::vector<std::string>& words, const std::string& before = ":") {
  std::string line = before + "; ulimit -v " + std::to_string(1024 * mib) + "; exec '" +
                     tolmanProgram().string() + "'";
  for (const std::string& word : words) line += " '" + word + "'";
  return run({"bash", "-c", line});
}

}  // namespace

TEST_CASE("data that do not fit into memory are said to be too much, not a defect") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "long.txt";
  {
    std::ofstream poses(file);
    for (int k = 0; k < 900'000; ++k) poses << k << " 0 0 0 0 0 0 1\n";
  }
  const Finished finished = within(300, {"eval", file.string(), file.string()});
  CHECK(finished.exit_code == 70);
  CHECK(finished.err == "tolman: out of memory; give it more (`ulimit -v`), or less to do\n");
  CHECK(finished.out.empty());
}

TEST_CASE("a plugin that takes all memory fails alone: the frames before are recorded") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 6);
  const fs::path config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const std::string out = (folder.path() / "run").string();
  const std::string fixtures = inBuild("tests/fixtures/plugins/");
  const Finished finished = within(
      1500, {"run", config.string(), "--out", out, "--plugin-path", fixtures + "process_faults",
             "--set", "odometry={plugin: eat_memory}", "--set", "threads=2"});
  CAPTURE(finished.exit_code, finished.err);
  CHECK(finished.exit_code == 70);
  CHECK(contains(finished.err, "odometry (eat_memory), track, frame 3: threw: std::bad_alloc"));
  const auto provenance = readJson(fs::path(out) / "run.json");
  CHECK(provenance["status"] == "failed");
  CHECK(provenance["counters"]["frames"] == 3);
  CHECK(fs::exists(fs::path(out) / "report.html"));
}

TEST_CASE("memory that ends while the source is configured is no fault of the data") {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "run").string();
  int told = 0;
  for (int mib = 170; mib <= 290; mib += 20) {
    const Finished finished =
        within(mib, {"run", "demo", "--set", "source.last=3", "--set", "threads=2", "--out", out});
    CAPTURE(mib, finished.exit_code, finished.err);
    if (!contains(finished.err, "std::bad_alloc")) continue;
    ++told;
    CHECK(finished.exit_code == 70);
  }
  CHECK(told > 0);
}

TEST_CASE("no limit of memory ends a command by a signal, or is told as anything else") {
  const TemporaryFolder folder;
  const fs::path sequence = folder.path() / "sequence";
  writeTinyKitti(sequence, 3);
  const std::string out = (folder.path() / "out").string();
  struct Command {
    std::vector<std::string> words;
    int least, most;  ///< MiB, around the point where libraries and the data just fit
  };
  int short_ones = 0;
  for (const Command& command :
       {Command{{"dataset", "check", sequence.string(), "--source", "kitti"}, 216, 240},
        Command{
            {"dataset", "import", sequence.string(), "--source", "kitti", "--out", out}, 216, 256},
        Command{{"init", sequence.string(), "--out", out}, 120, 240},
        Command{{"run", "demo", "--set", "source.last=2", "--set", "threads=2", "--out", out},
                304,
                352}}) {
    for (int mib = command.least; mib <= command.most; mib += (command.most - command.least) / 8) {
      const Finished finished = within(mib, command.words);
      CAPTURE(command.words[1], mib, finished.err);
      const bool is_plugin = finished.exit_code == 4 && contains(finished.err, "ulimit");
      CHECK((is_plugin || finished.exit_code == 70 || finished.exit_code == 0));
      short_ones += finished.exit_code == 70 ? 1 : 0;
      fs::remove_all(out);
    }
  }
  CHECK(short_ones > 5);
}

TEST_CASE("a run without memory for its report or its record does not say that it is finished") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 20);
  const fs::path config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const fs::path out = folder.path() / "run";
  auto words = tinyRun(config, out);
  for (const char* word : {"--set", "threads=1"}) words.emplace_back(word);
  int unfinished = 0;
  for (int mib = 120; mib <= 290; mib += mib < 260 ? 20 : 1) {
    const Finished finished = within(mib, words);
    CAPTURE(mib, finished.exit_code, finished.err);
    // libgfortran, which BLAS needs, ends the process with 1 where its initialiser finds no memory.
    const bool is_fortran = contains(finished.err, "Allocating cleared memory failed");
    CHECK((std::set{0, 4, 70}.contains(finished.exit_code) || is_fortran));
    if (fs::exists(out / "run.json")) {
      const bool is_finished = readJson(out / "run.json")["status"] == "finished";
      CHECK(is_finished == (finished.exit_code == 0));
      if (is_finished) CHECK(fs::exists(out / "report.html"));
      unfinished += is_finished ? 0 : 1;
    }
    fs::remove_all(out);
  }
  CHECK(unfinished > 0);
}

TEST_CASE("threads that find no room for their stacks are said to lack memory") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 2);
  const std::string config = writeTinyConfig(folder.path(), folder.path() / "sequence").string();
  int told = 0;
  for (int mib = 70; mib <= 140; mib += 10) {
    const Finished finished =
        within(mib, {"run", config, "--out", (folder.path() / "run").string()}, "ulimit -s 65536");
    CAPTURE(mib, finished.exit_code, finished.err);
    // 127: the system's loader, before the program begins.
    CHECK((finished.exit_code == 4 || finished.exit_code == 70 || finished.exit_code == 127));
    if (finished.exit_code != 70) continue;
    ++told;
    CHECK(finished.err.starts_with("tolman: out of memory"));
  }
  CHECK(told > 0);
}

TEST_CASE("too few threads are told before a library fails for want of one") {
  if (::geteuid() != 0) return;  // limits count all processes of a user; root can be one without
  const auto limited = [](const std::string& line) {
    return run({"setpriv", "--reuid=54321", "--regid=54321", "--clear-groups", "bash", "-c",
                line + tolmanProgram().string() + " version"});
  };
  if (limited("exec ").exit_code != 0) return;  // the build lies in a folder of its owner
  for (const char* limit : {"2", "5", "9"}) {
    const Finished finished = limited("ulimit -u " + std::string(limit) + "; exec ");
    CAPTURE(limit, finished.out, finished.err);
    CHECK(finished.exit_code == 70);
    CHECK(contains(finished.err, "fewer than 16 threads can be started"));
  }
}

TEST_CASE("threads that a plugin's process lacks are told as a limit, not as the plugin's defect") {
  if (::geteuid() != 0) return;  // as above
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 2);
  const fs::path config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  fs::permissions(folder.path(), fs::perms::all);
  const std::string library = inBuild("tests/fixtures/plugins/steady/tolman_odometry_steady.so");
  const auto limited = [&](int limit, const std::string& words) {
    return run({"setpriv", "--reuid=54322", "--regid=54322", "--clear-groups", "bash", "-c",
                "ulimit -u " + std::to_string(limit) + "; exec " + tolmanProgram().string() + " " +
                    words});
  };
  if (limited(64, "version").exit_code != 0) return;  // the build lies in a folder of its owner
  int told = 0;
  for (const int limit : {17, 18, 19, 21}) {
    for (const std::string& words :
         {"check " + config.string() + " --plugin-path " + fs::path(library).parent_path().string(),
          "plugins doctor " + library, "plugins validate --level 1 --check load " + library,
          "init " + folder.path().string()}) {
      if (words.starts_with("init") && limit != 18) continue;  // it starts many processes
      const Finished finished = limited(limit, words);
      CAPTURE(limit, words, finished.exit_code, finished.out, finished.err);
      const bool is_init = words.starts_with("init");  // no source reads the folder: 5
      CHECK((finished.exit_code == (is_init ? 5 : 0) || finished.exit_code == 70));
      CHECK_FALSE(contains(finished.err + finished.out, "plugin/died"));
      CHECK_FALSE(contains(finished.out, "never call exit()"));
      if (finished.exit_code != 70) continue;
      CHECK(contains(finished.err, "ulimit -u"));
      told += contains(finished.err, "plugin/no-process") ? 1 : 0;
    }
  }
  CHECK(told > 0);
}

TEST_CASE("libraries that find no room are refused as plugins, with the limits as the remedy") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 2);
  const std::string config = writeTinyConfig(folder.path(), folder.path() / "sequence").string();
  int refused = 0;
  for (int mib = 90; mib <= 330; mib += 20) {
    const Finished finished =
        within(mib, {"check", config, "--plugin-path", inBuild("tests/fixtures/plugins/steady")});
    CAPTURE(mib, finished.exit_code, finished.err);
    // 127: the system's loader, before the program begins.
    CHECK((finished.exit_code == 0 || finished.exit_code == 4 || finished.exit_code == 70 ||
           finished.exit_code == 127));
    if (finished.exit_code != 4) continue;
    ++refused;
    CHECK(contains(finished.err, "plugin/load-failed"));
    CHECK(contains(finished.err, "limits of this process"));
  }
  CHECK(refused > 0);
}
