// SPDX-License-Identifier: BSD-3-Clause
// Files beside run.sqlite that are not those of the run, or that are missing.
#include "record/run_check.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "record/digest.hpp"
#include "record/run_directory.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;
namespace fs = std::filesystem;

namespace {

/// The files of a run that has ended.
struct EndedRun {
  test::TemporaryFolder folder;
  nlohmann::ordered_json run_file;

  EndedRun() {
    write("config.resolved.yaml", "seed: 1\n");
    write("metrics.json", "{}\n");
    write("trajectory.tum", "0 0 0 0 0 0 0 1\n");
    REQUIRE(writeResultsDigest(folder.path()).isOk());
    run_file[kConfigDigest] = fileDigest(folder.path() / "config.resolved.yaml").value();
    say("finished");
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder.path() / name) << text;
  }
  void say(const std::string& status) {
    run_file["status"] = status;
    write("run.json", run_file.dump());
  }
  void remove(const std::string& name) const { REQUIRE(fs::remove(folder.path() / name)); }
  std::string named(const std::string& name) const { return (folder.path() / name).string(); }
  std::string configProblem() const { return checkConfig(folder.path(), run_file).message(); }
  std::string missing() const { return checkEndFiles(folder.path()).message(); }
};

}  // namespace

TEST_CASE("a configuration that was edited, exchanged or removed is not the run's") {
  EndedRun run;
  CHECK(run.configProblem().empty());
  run.write("config.resolved.yaml", "seed: 2\n");
  CHECK(run.configProblem() ==
        run.named("config.resolved.yaml") +
            ": has changed since the run was recorded; put it back, or run it again");
  run.remove("config.resolved.yaml");
  CHECK(run.configProblem() ==
        run.named("config.resolved.yaml") + ": is missing; put it back, or run it again");
  run.run_file.erase(kConfigDigest);
  CHECK(run.configProblem().empty());  // nothing to compare with
}

TEST_CASE("a digest of the configuration that is no text is told as a change") {
  EndedRun run;
  run.run_file[kConfigDigest] = 3;
  CHECK_FALSE(run.configProblem().empty());
}

TEST_CASE("files that an ended run lacks are named together") {
  EndedRun run;
  CHECK(run.missing().empty());
  run.remove("trajectory.tum");
  run.remove("metrics.json");
  CHECK(run.missing() ==
        run.folder.path().string() +
            ": the run has ended, but files of its end are missing: metrics.json, "
            "trajectory.tum; put them back, or repeat the run with `tolman rerun`");
  run.remove("results.sha256");
  CHECK(run.missing().find("metrics.json, results.sha256;") != std::string::npos);
}

TEST_CASE("a run that goes on, was killed or has failed has no files of its end") {
  for (const char* status : {"running", "failed"}) {
    EndedRun run;
    run.say(status);
    run.remove("metrics.json");
    CHECK(run.missing().empty());
  }
}
