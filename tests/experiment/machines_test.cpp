// SPDX-License-Identifier: BSD-3-Clause
// Sweeps by Slurm, GNU parallel and Snakemake: the same results, and no files or processes remain.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <iostream>
#include <thread>

#include "experiment/slurm_cluster.hpp"
#include "experiment/study.hpp"
#include "support/data.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// Two periods, two seeds, a sequence on a front end of its own and one without; one run that
/// fails, and one that takes 40 s (frames at 10 Hz), time enough to kill it.
constexpr const char* kRuns =
    "set: {odometry.noise_distance: 0.02}\n"
    "grid: {cells.period: [100, 150]}\n"
    "list: {state: {good: {}, fails: {source.odometry: none.g2o}, slow: {pipeline.mode: "
    "realtime}}}\n"
    "sequences: {a: {front_end: {base: motion.yaml, source.path: a}}, b: b}\n"
    "seeds: 2\n";
constexpr const char* kGood = "exclude: [{state: [fails, slow]}]\n";
constexpr const char* kOneOfEach =
    "exclude: [{state: [fails, slow], sequence: a}, {state: [fails, slow], seed: 2}, "
    "{state: [fails, slow], cells.period: 150}]\n";
constexpr const char* kFails = "period=100,state=fails,sequence=b,seed=1";
constexpr const char* kSlow = "period=100,state=slow,sequence=b,seed=1";

bool isInstalled(const std::string& program) {
  const bool found = run({"which", program}).exit_code == 0;
  if (!found) {
    std::cerr << "SKIPPED: " << program
              << " is not installed (scripts/install-dependencies --machines)\n";
    skips().push_back(program);
  }
  return found;
}

}  // namespace

TEST_CASE("an array of Slurm, with a task that fails and one that is killed", "[optional]") {
  const auto slurm = SlurmCluster::start();
  if (!slurm) {
    isInstalled("slurmctld");
    return;
  }
  const Study study;
  study.writeAll(std::string(kRuns) + kGood);
  REQUIRE(study.sweep({}, "local").exit_code == 0);
  const auto local = study.results("local");
  CHECK(local.size() == 9);  // eight, and the front end

  study.writeAll(std::string(kRuns) + kOneOfEach);
  REQUIRE(study.sweep({"--write", "slurm"}).exit_code == 0);
  slurm->give(study.folder.path());
  const bool is_up = slurm->waitUntilIdle();
  INFO(slurm->logs());
  REQUIRE(is_up);
  const Finished submitted = slurm->run({"sh", (study.out() / "submit.sh").string()});
  INFO(submitted.err);
  REQUIRE(submitted.exit_code == 0);
  CHECK(std::ranges::count(submitted.out, '\n') == 2);  // two arrays, and submit.sh has ended

  // The slow task is killed as a machine that fails would: without a chance to write anything.
  const fs::path slow = study.point(kSlow);
  for (int i = 0; i < 600 && !fs::exists(slow / "run/run.json"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  REQUIRE(contains(study.status(), "running      1"));
  const std::string id = slurm->run({"pgrep", "-f", "sweep point " + slow.string()}).out;
  REQUIRE(slurm->run({"kill", "-KILL", id.substr(0, id.find('\n'))}).exit_code == 0);
  REQUIRE(slurm->waitUntilDone());

  const std::string status = study.status();
  INFO(status);
  CHECK(contains(status, "interrupted  1\ndone         9\nfailed       1\n"));
  CHECK(contains(status, std::string(kFails) + "\n"));
  auto results = study.results();
  results.erase(kSlow);
  CHECK(results == local);
  const Finished collected = tolman::test::tolman({"sweep", "collect", study.out().string()});
  REQUIRE(collected.exit_code == 0);
  const std::string csv = readText(study.out() / "results.csv");
  CHECK(std::ranges::count(csv, '\n') == 9);

  // What is left to do: the killed one, and on demand the failed one.
  REQUIRE(study.sweep({"--write", "slurm", "--retry"}).exit_code == 0);
  const std::string left = readText(study.out() / "runs-1.txt");
  CHECK(std::ranges::count(left, '\n') == 2);
  CHECK(contains(left, slow.string()));
}

TEST_CASE("GNU parallel runs the lists of commands", "[optional]") {
  if (!isInstalled("parallel")) return;
  const Study study;
  study.writeAll(std::string(kRuns) + kGood);
  REQUIRE(study.sweep({}, "local").exit_code == 0);
  REQUIRE(study.sweep({"--write", "parallel"}).exit_code == 0);
  for (const char* list : {"commands-1.txt", "commands-2.txt"}) {
    const Finished done = run(
        {"parallel", "--will-cite", "--jobs", "2", "--arg-file", (study.out() / list).string()});
    INFO(done.err);
    CHECK(done.exit_code == 0);
  }
  CHECK(study.results() == study.results("local"));
}

TEST_CASE("Snakemake runs its file, and what has failed does not stop the rest", "[optional]") {
  if (!isInstalled("snakemake")) return;
  const Study study;
  study.writeAll(std::string(kRuns) + kGood);
  REQUIRE(study.sweep({}, "local").exit_code == 0);
  study.writeAll(std::string(kRuns) + "exclude: [{state: slow}, {state: fails, sequence: a}]\n");
  REQUIRE(study.sweep({"--write", "snakemake"}).exit_code == 0);
  const Finished done =
      run({"env", "HOME=" + study.folder.path().string(), "snakemake", "-s",
           (study.out() / "Snakefile").string(), "-d", study.folder.path().string(), "--cores", "2",
           "--keep-going", "--nolock"});
  INFO(done.err);
  CHECK(done.exit_code != 0);  // some fail
  CHECK(study.results() == study.results("local"));
  CHECK(contains(study.status(), "failed       4\n"));
}
