// SPDX-License-Identifier: BSD-3-Clause
// Sweeps by the program: planned, run, killed, continued, extended, compared.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "experiment/motion_folder.hpp"
#include "experiment/study.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

TEST_CASE("a sweep runs all points once, and what is added later") {
  const Study study;
  const Finished planned = study.sweep({"--dry-run"});
  INFO(planned.err);
  REQUIRE(planned.exit_code == 0);
  CHECK(contains(planned.out, "study: 12 runs"));
  CHECK(contains(planned.out, "  period=100,sequence=b,seed=3\n"));
  CHECK_FALSE(fs::exists(study.out()));

  const Finished first = study.sweep();
  INFO(first.err);
  REQUIRE(first.exit_code == 0);
  CHECK(contains(first.err, "12 of 12"));
  const auto results = study.results();
  CHECK(results.size() == 12);
  CHECK(results.at("period=100,sequence=a,seed=1") != results.at("period=100,sequence=a,seed=2"));

  // A run of the sweep has the results of the same configuration by itself.
  const Finished alone = tolman::test::tolman(
      {"run", (study.folder.path() / "motion.yaml").string(), "--quiet", "--out",
       study.out("alone").string(), "--set", "odometry.noise_distance=0.02", "--set",
       "odometry.noise_heading=0.002", "--set", "cells.period=100", "--seed", "2"});
  REQUIRE(alone.exit_code == 0);
  CHECK(readText(study.out("alone") / "results.sha256") ==
        results.at("period=100,sequence=a,seed=2"));

  study.write("seeds: 4\n");
  const Finished more = study.sweep({"--jobs", "1"});
  REQUIRE(more.exit_code == 0);
  CHECK(contains(more.out, "done      12\n"));
  CHECK(contains(more.err, "4 of 4"));
  CHECK(study.results().size() == 16);
  study.write("seeds: [4]\n");
  CHECK(contains(study.sweep({"--dry-run"}).out, "done      4\nto do     0\n"));
}

TEST_CASE("an invalid point is reported with key, file and line before anything runs") {
  const Study study;
  study.write("list: {model: {good: {}, bad: {cells.perod: 3, place.kept: 7}}}\n");
  const Finished finished = study.sweep();
  CHECK(finished.exit_code == 3);
  CHECK(contains(finished.err, ": cells.perod: unknown parameter"));
  CHECK(contains(finished.err, "study.yaml:5:"));
  CHECK(contains(finished.err, "did you mean 'period'"));
  CHECK(contains(finished.err, "place.kept: 7 is out of range"));
  CHECK_FALSE(fs::exists(study.out()));
}

TEST_CASE("a sweep that is killed goes on and ends with the same results") {
  const Study study;
  REQUIRE(study.sweep({}, "whole").exit_code == 0);
  for (const int signal : {SIGKILL, SIGINT, SIGKILL}) {
    Words command = study.words();
    command.insert(command.begin(), tolmanProgram().string());
    const std::size_t before = fs::exists(study.out()) ? study.results().size() : 0;
    const TemporaryFolder output;
    Process process(command, output.path());
    for (int i = 0; i < 3000 && (!fs::exists(study.out()) || study.results().size() <= before);
         ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    process.signal(signal);
    process.wait();
  }
  Finished last = study.sweep();
  for (int i = 0; i < 100 && last.exit_code == 8;
       ++i) {  // processes of the killed one may still end
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    last = study.sweep();
  }
  INFO(last.err);
  CHECK(last.exit_code == 0);
  CHECK(study.results() == study.results("whole"));
}

TEST_CASE("a run that fails is reported, kept, and repeated on demand") {
  const Study study;
  study.write("list: {log: {right: {}, wrong: {source.odometry: none.g2o}}}\n");
  const Finished first = study.sweep();
  CHECK(first.exit_code == 7);
  CHECK(contains(first.err, "none.g2o: is missing"));
  CHECK(study.results().size() == 4);
  const Finished status = tolman::test::tolman({"sweep", "status", study.out().string()});
  CHECK(contains(status.out, "done         4\nfailed       4\n"));
  const Finished again = study.sweep();
  CHECK(again.exit_code == 7);
  CHECK(contains(again.out, "failed    4 (--retry)"));
  CHECK_FALSE(contains(again.err, "none.g2o"));
  CHECK(contains(study.sweep({"--retry"}).err, "none.g2o"));
}

TEST_CASE("data that change after planning are reported; planning again makes new runs") {
  const Study study;
  REQUIRE(study.sweep({"--freeze"}).exit_code == 0);
  writeMotionFolder(study.folder.path() / "b", 0.004);
  int changed = 0;
  for (const auto& entry : fs::directory_iterator(study.out())) {
    if (!entry.is_directory()) continue;
    const Finished point = tolman::test::tolman({"sweep", "point", entry.path().string()});
    if (point.exit_code != 5) continue;
    ++changed;
    CHECK(contains(point.err, "/b has changed since the run was planned"));
  }
  CHECK(changed == 6);
  CHECK(study.results().size() == 6);
  const Finished again = study.sweep();
  CHECK(again.exit_code == 0);
  CHECK(contains(again.out, "done      6\n"));
  CHECK(study.results().size() == 12);
  // The six runs on the earlier data stay, and are neither counted nor compared.
  CHECK(contains(study.status(), "done         12\nnot counted  6 of earlier plans\n"));
  const auto csv = (study.folder.path() / "now.csv").string();
  CHECK(tolman::test::tolman({"sweep", "collect", study.out().string(), "--out", csv}).exit_code ==
        0);
  const std::string rows = readText(csv);
  CHECK(std::ranges::count(rows, '\n') == 1 + 12);
  CHECK(rows.find("\n\"period=100,sequence=a,seed=1\"") < rows.find("period=100,sequence=b"));
  const std::string one = (study.folder.path() / "one.csv").string();
  REQUIRE(tolman::test::tolman({"sweep", "collect", study.out().string(), "--out", one, "--metric",
                                "map.ate.rmse_m"})
              .exit_code == 0);
  // With what compare refuses by: exit code, coverage, lengths of segments.
  CHECK(contains(readText(one), ",exit_code,map.ate.rmse_m,map.coverage,"));
  CHECK_FALSE(contains(readText(one), "path_length"));
}

TEST_CASE("the folder of a sweep may not lie in data that its runs read") {
  const Study study;
  study.writeAll("sequences: {a: a}\n");
  const Finished inside = study.sweep({}, "a/out");
  CHECK(inside.exit_code == 8);
  CHECK(contains(inside.err, "lies in data that the runs read"));
  CHECK_FALSE(fs::exists(study.out("a/out")));
  CHECK(study.sweep({}, "beside").exit_code == 0);
}

TEST_CASE("a frozen configuration that was edited refuses to run") {
  const Study study;
  REQUIRE(study.sweep({"--freeze"}).exit_code == 0);
  fs::path point;
  for (const auto& entry : fs::directory_iterator(study.out())) {
    if (fs::exists(entry.path() / "point.json")) point = entry.path();
  }
  std::ofstream(point / "config.yaml", std::ios::app) << "# edited\n";
  const Finished edited = tolman::test::tolman({"sweep", "point", point.string()});
  CHECK(edited.exit_code == 3);
  CHECK(contains(edited.err, "config.yaml has changed since the run was planned"));
  CHECK_FALSE(fs::exists(point / "run/run.json"));
  fs::remove_all(point);
  CHECK(study.sweep().exit_code == 0);
  CHECK(fs::exists(point / "run/run.json"));
}

TEST_CASE("a run whose directory was removed is run again, with the same results") {
  const Study study;
  REQUIRE(study.sweep().exit_code == 0);
  const auto before = study.results();
  for (const auto& entry : fs::directory_iterator(study.out())) {
    if (!fs::exists(entry.path() / "point.json")) continue;
    fs::remove_all(entry.path() / "run");
    break;
  }
  CHECK(study.results().size() + 1 == before.size());
  CHECK(contains(study.status(), "planned      1\n"));
  CHECK(study.sweep().exit_code == 0);
  CHECK(study.results() == before);
}

TEST_CASE("a front end is run once, and its noise follows the seed") {
  const Study study;
  std::ofstream(study.file())
      << "base: motion.yaml\n"
         "set: {odometry.noise_distance: 0.02}\n"
         "grid: {cells.period: [100, 150]}\n"
         "sequences: {a: {front_end: {base: motion.yaml, source.path: a}}}\n"
         "seeds: 3\n";
  const Finished planned = study.sweep({"--dry-run"});
  INFO(planned.err);
  CHECK(contains(planned.out, "6 runs, after 1 that they need"));
  const Finished finished = study.sweep();
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const auto results = study.results();
  CHECK(results.size() == 7);
  CHECK(results.at("period=100,sequence=a,seed=1") != results.at("period=100,sequence=a,seed=2"));
  CHECK(contains(study.sweep().out, "done      7\n"));  // the keys do not depend on the folder
}

TEST_CASE("points continue the map of a first session, which is run once") {
  const Study study;
  study.writeAll(
      "set: {source.path: a, evaluation.sessions: joint, source.truth_origin: data}\n"
      "list:\n"
      "  way:\n"
      "    one: {source.last: 59}\n"
      "    two: {first_session: {source.last: 29}, source.first: 30, source.last: 59}\n"
      "grid: {evaluation.alignment: [se2, se3]}\n");
  CHECK(contains(study.sweep({"--dry-run"}).out, "4 runs, after 1 that they need"));
  const Finished finished = study.sweep();
  INFO(finished.out << finished.err);
  REQUIRE(finished.exit_code == 0);
  const auto sessions = [&](const std::string& run) {
    return readJson(study.point(run) / "run/metrics.json")["sessions"].size();
  };
  CHECK(sessions("alignment=se2,way=one") == 1);
  CHECK(sessions("alignment=se2,way=two") == 2);
  CHECK(sessions("alignment=se3,way=two") == 2);
  CHECK(contains(study.sweep().out, "done      5\n"));
}

TEST_CASE("the list of commands gives the same results, also from its end to its beginning") {
  const Study study;
  study.writeAll(
      "set: {odometry.noise_distance: 0.02}\n"
      "grid: {cells.period: [100, 150]}\n"
      "sequences: {a: {front_end: {base: motion.yaml, source.path: a}}, b: b}\n");
  REQUIRE(study.sweep({}, "whole").exit_code == 0);
  REQUIRE(study.sweep({"--freeze"}).exit_code == 0);
  const std::string list = (study.out() / "commands.txt").string();
  REQUIRE(run({"sh", "-c", "tac '" + list + "' | sh"}).exit_code == 0);
  CHECK(study.results() == study.results("whole"));
  CHECK(contains(study.sweep().out, "to do     0"));
}

TEST_CASE("results are collected and compared") {
  const Study study;
  REQUIRE(study.sweep().exit_code == 0);
  const std::string out = study.out().string();
  REQUIRE(tolman::test::tolman({"sweep", "collect", out}).exit_code == 0);
  const std::string csv = readText(study.out() / "results.csv");
  CHECK(csv.starts_with("name,cells.period,sequence,seed,alignment,truth_sha256,results_sha256,"));
  CHECK(std::ranges::count(csv, '\n') == 13);
  const std::string figure = (study.folder.path() / "figure.svg").string();
  const Finished table = tolman::test::tolman({"compare", out, "--figure", figure});
  INFO(table.err);
  REQUIRE(table.exit_code == 0);
  CHECK(contains(table.out, "| cells.period | runs | mean |"));
  CHECK(contains(table.out, "| 150 | 6 | "));
  CHECK(contains(readText(figure), "<svg"));
  CHECK(tolman::test::tolman({"compare", out, "--metric", "map.ate.rmse"}).exit_code == 2);
  CHECK(tolman::test::tolman({"compare", out, "--format", "latex"}).out.find("\\toprule") !=
        std::string::npos);
  const std::string copy = (study.folder.path() / "copy").string();
  std::filesystem::copy(study.out(), copy, std::filesystem::copy_options::recursive);
  const Finished twice = tolman::test::tolman({"compare", out, copy});
  CHECK(contains(twice.out, "| 150 | 6 | "));
  CHECK(contains(twice.out, "12 of 24 runs were given twice"));
}

TEST_CASE("options of a comparison that would have no effect are refused") {
  for (const Words& unused :
       {Words{"--columns", "sequence", "--figure", "figure.svg"}, Words{"--cell", "{frames:.0f}"},
        Words{"--head", "a={frames:.0f}"}, Words{"--over", "sequence"}}) {
    Words words = {"compare", "runs"};
    words.insert(words.end(), unused.begin(), unused.end());
    const Finished refused = tolman::test::tolman(words);
    INFO(refused.err);
    CHECK(refused.exit_code == 2);
  }
}

TEST_CASE("a figure from the records: maps over the true path") {
  const Study study;
  REQUIRE(study.sweep().exit_code == 0);
  const auto draw = [&](const std::string& name, const Words& more) {
    Words words = {"compare",    study.out().string(), "--only",
                   "sequence=a", "--figure",           (study.folder.path() / name).string()};
    words.insert(words.end(), more.begin(), more.end());
    return tolman::test::tolman(words);
  };
  REQUIRE(draw("m.svg", {"--maps"}).exit_code == 0);
  const std::string maps = readText(study.folder.path() / "m.svg");
  for (const char* name : {">truth<", ">100<", ">150<"}) CHECK(contains(maps, name));
  REQUIRE(draw("b.pdf", {}).exit_code == 0);
  CHECK(readText(study.folder.path() / "b.pdf").starts_with("%PDF-"));
  // The table needs none of the records.
  for (const auto& entry : fs::directory_iterator(study.out())) {
    if (entry.is_directory()) fs::remove(entry.path() / "run/run.sqlite");
  }
  CHECK(tolman::test::tolman({"compare", study.out().string()}).exit_code == 0);
  CHECK(draw("x.svg", {"--maps"}).exit_code != 0);
}

TEST_CASE("missing data are reported before anything runs") {
  const Study study;
  fs::remove_all(study.folder.path() / "b");
  const Finished planned = study.sweep({"--dry-run"});
  CHECK(planned.exit_code == 0);
  CHECK(contains(planned.out, "warning   " + (study.folder.path() / "b").string() +
                                  " does not exist: the runs that read it will fail"));
}

TEST_CASE("a run to continue that does not exist is reported before anything runs") {
  const Study study;
  const std::string earlier = (study.folder.path() / "earlier").string();
  std::ofstream(study.file()) << "base: motion.yaml\ngrid: {continue: [" << earlier << "]}\n";
  const Finished planned = study.sweep({"--dry-run"});
  INFO(planned.err);
  CHECK(planned.exit_code == 0);
  CHECK(contains(planned.out,
                 "warning   " + earlier + " does not exist: the runs that read it will fail"));
}

TEST_CASE("ten thousand points are planned") {
  const Study study;
  std::ofstream(study.file())
      << "base: motion.yaml\n"
         "random: {count: 1000, keys: {cells.period: {min: 50, max: 300}}}\n"
         "seeds: 10\n";
  const Finished planned = study.sweep({"--dry-run"});
  INFO(planned.err.substr(0, 2000));
  CHECK(planned.exit_code == 0);
  CHECK(contains(planned.out, "10000 runs"));
}
