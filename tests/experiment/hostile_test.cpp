// SPDX-License-Identifier: BSD-3-Clause
// Failures in sweeps: each is reported, affects one run only, and no results are lost.
#include <sys/mount.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "experiment/motion_folder.hpp"
#include "experiment/study.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

TEST_CASE("a plugin that crashes in one run of ten concerns that run only") {
  const Study study;
  study.writeAll(
      "set: {odometry: {plugin: crashes_when_fast}}\n"
      "grid: {odometry.speed: [1, 2, 3, 4, 5, 6, 7, 8, 9, 45]}\n");
  const Words path = {"--plugin-path", inBuild("tests/fixtures/plugins/process_faults")};
  Words command = path;
  for (const std::string& word : study.words({"--jobs", "2"})) command.push_back(word);
  const Finished first = tolman::test::tolman(command);
  INFO(first.out << first.err);
  CHECK(first.exit_code == 7);
  CHECK(contains(first.err, "speed=45"));
  CHECK(contains(first.err, "the process died of SIGABRT"));
  CHECK(study.results().size() == 9);
  const std::string status = study.status();
  CHECK(contains(status, "done         9\nfailed       1\n"));
  CHECK(contains(status, "the process died of SIGABRT"));
  const Finished table =
      tolman::test::tolman({"compare", study.out().string(), "--metric", "frames"});
  CHECK(table.exit_code == 0);
  CHECK(contains(table.err,
                 "warning: " + study.out().string() +
                     ": of 10 runs 1 failed and 0 are not done, and are not in the table"));
  const auto before = study.results();
  command.emplace_back("--retry");
  CHECK(tolman::test::tolman(command).exit_code == 7);  // it dies again, the others are not run
  CHECK(study.results() == before);
}

TEST_CASE("data that change between two runs: later runs refuse, earlier results stay") {
  const Study study;
  REQUIRE(study.sweep({"--freeze"}).exit_code == 0);
  const fs::path first = study.point("period=100,sequence=a,seed=1");
  REQUIRE(tolman::test::tolman({"--quiet", "sweep", "point", first.string()}).exit_code == 0);
  const auto before = study.results();
  writeMotionFolder(study.folder.path() / "a", 0.004);
  const Finished second = tolman::test::tolman(
      {"--quiet", "sweep", "point", study.point("period=100,sequence=a,seed=2").string()});
  CHECK(second.exit_code == 5);
  CHECK(contains(second.err, "has changed since the run was planned"));
  CHECK(study.results() == before);
  CHECK(contains(study.status(), "planned      10\ndone         1\nfailed       1\n"));
}

TEST_CASE("a full disk is reported, and with room the sweep continues to the same results") {
  const Study study;
  REQUIRE(study.sweep({}, "whole").exit_code == 0);
  fs::create_directories(study.out());
  if (::mount("none", study.out().c_str(), "tmpfs", 0, "size=3m") != 0) {
    WARN("SKIPPED: a small file system needs root");
    return;
  }
  const Finished full = study.sweep({"--jobs", "2"});
  INFO(full.out << full.err);
  const bool larger = ::mount("none", study.out().c_str(), "tmpfs", MS_REMOUNT, "size=200m") == 0;
  const std::string status = study.status();
  const Finished rest = study.sweep({"--retry"});
  const auto results = study.results();
  ::umount(study.out().c_str());
  CHECK(full.exit_code != 0);
  CHECK(larger);
  INFO(status);
  INFO(rest.out << rest.err);
  CHECK(rest.exit_code == 0);
  CHECK(results == study.results("whole"));
}

TEST_CASE("a run whose folder is gone is missing, in all that a sweep tells of its runs") {
  const Study study;
  REQUIRE(study.sweep().exit_code == 0);
  const fs::path point = study.point("period=100,sequence=a,seed=1");
  fs::remove(point / "point.json");
  const std::string missing =
      "missing      1 without a readable point.json\n  " + point.filename().string() + "\n";
  CHECK(contains(study.status(), missing));
  const std::string warning = "1 have no readable point.json, and are not in the table";
  const Finished table = tolman::test::tolman({"sweep", "collect", study.out().string()});
  CHECK(table.exit_code == 0);
  CHECK(contains(table.err, warning));
}

TEST_CASE("an outcome that is damaged concerns its run only") {
  const Study study;
  REQUIRE(study.sweep().exit_code == 0);
  const fs::path outcome = study.point("period=100,sequence=a,seed=1") / "outcome.json";
  std::ofstream(outcome) << "{\"state\": 3}";
  CHECK(contains(study.status(), "outcome.json: is damaged; remove it"));
}

TEST_CASE("tables and figures are not written over what they are made of") {
  const Study study;
  REQUIRE(study.sweep().exit_code == 0);
  const fs::path run = study.point("period=100,sequence=a,seed=1") / "run";
  const fs::path table = study.folder.path() / "runs.csv";
  REQUIRE(tolman::test::tolman({"sweep", "collect", study.out().string(), "--out", table.string()})
              .exit_code == 0);
  const auto compare = [](const fs::path& runs, const std::string& option, const fs::path& file) {
    return tolman::test::tolman({"compare", runs.string(), option, file.string()});
  };
  for (const Finished& refused :
       {compare(study.out(), "--out", run / "run.sqlite"), compare(table, "--out", table),
        compare(study.out(), "--figure", run / "map.svg")}) {
    CHECK(refused.exit_code == 8);
    CHECK(contains(refused.err, ": exists; choose another "));
  }
  CHECK(compare(study.out(), "--out", study.out() / "table.md").exit_code == 0);
  CHECK(compare(study.out(), "--figure", study.folder.path() / "f.gif").exit_code == 2);
}

TEST_CASE("a name that no file system takes is reported") {
  const Finished refused = tolman::test::tolman({"compare", std::string(256, 'y')});
  CHECK(refused.exit_code == 5);
  CHECK(contains(refused.err, "does not exist; check the path"));
}

TEST_CASE("a sweep without any run that is done gives no empty table") {
  const Study study;
  REQUIRE(study.sweep({"--freeze"}).exit_code == 0);
  const Finished table = tolman::test::tolman({"sweep", "collect", study.out().string()});
  CHECK(table.exit_code == 5);
  CHECK(contains(table.err, "no run is done"));
}

TEST_CASE("a run is not repeated onto itself, by whatever name") {
  const Study study;
  REQUIRE(study.sweep().exit_code == 0);
  const fs::path run = study.point("period=100,sequence=a,seed=1") / "run";
  const fs::path link = study.folder.path() / "link";
  fs::create_directory_symlink(run, link);
  for (const fs::path& out : {run, link}) {
    const Finished again =
        tolman::test::tolman({"rerun", run.string(), "--verify", "--force", "--out", out.string()});
    CHECK(again.exit_code == 2);
    CHECK(contains(again.err, "is the run itself; give another folder with --out"));
  }
  fs::remove(run / "results.sha256");
  const Finished blind = tolman::test::tolman({"rerun", run.string(), "--verify"});
  CHECK(blind.exit_code == 5);
  CHECK(contains(blind.err, "results.sha256: has no digests"));
  CHECK_FALSE(fs::exists(run.string() + "-again"));  // said before the run was made
}

TEST_CASE("a sweep and its table replace files of other programs only by force") {
  const Study study;
  const fs::path commands = study.out() / "commands.txt";
  fs::create_directories(study.out());
  std::ofstream(commands) << "mine\n";
  const Finished refused = study.sweep({"--freeze"});
  CHECK(refused.exit_code == 8);
  CHECK(contains(refused.err, "out: exists; choose another --out, or replace it with --force"));
  CHECK(readText(commands) == "mine\n");
  REQUIRE(study.sweep({"--freeze", "--force"}).exit_code == 0);
  CHECK(contains(readText(commands), "'sweep' 'point' '"));
  REQUIRE(study.sweep({"--freeze"}).exit_code == 0);  // now it is a sweep's folder
  REQUIRE(study.sweep().exit_code == 0);

  const fs::path table = study.folder.path() / "mine.csv";
  std::ofstream(table) << "years of work\n";
  std::vector<std::string> collect = {"sweep", "collect", study.out().string(), "--out",
                                      table.string()};
  const Finished kept = tolman::test::tolman(collect);
  CHECK(kept.exit_code == 8);
  CHECK(contains(kept.err, "mine.csv: exists; choose another --out"));
  CHECK(readText(table) == "years of work\n");
  collect.emplace_back("--force");
  CHECK(tolman::test::tolman(collect).exit_code == 0);
}
