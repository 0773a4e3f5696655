// SPDX-License-Identifier: BSD-3-Clause
// Plugins that break their promises: each has its message and exit code, and what was done before
// is kept.
#include <catch2/catch.hpp>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

const std::string kFixtures = inBuild("tests/fixtures/plugins/");

/// Runs the tiny sequence with another odometry, from the fixture library `library`.
struct Attempt {
  TemporaryFolder folder;
  fs::path out = folder.path() / "run";
  Finished finished;

  Attempt(const std::string& library, const std::string& plugin,
          const std::vector<std::string>& more = {}) {
    writeTinyKitti(folder.path() / "sequence", 6);
    const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
    std::vector<std::string> arguments = {
        "run",           config.string(),     "--out", out.string(),
        "--plugin-path", kFixtures + library, "--set", "odometry={plugin: " + plugin + "}"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    finished = tolman::test::tolman(arguments);
  }
};

}  // namespace

TEST_CASE("libraries that must not be opened end with exit code 4 and their id") {
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"no_manifest", "plugin/no-manifest"},     {"bad_json", "plugin/bad-manifest"},
      {"wrong_major", "plugin/sdk-major"},       {"newer_minor", "plugin/sdk-minor"},
      {"entry_missing", "plugin/entry-missing"}, {"missing_symbol", "plugin/load-failed"},
      {"returns_null", "plugin/null-instance"}};
  for (const auto& [plugin, id] : refused) {
    const Attempt attempt(plugin, plugin);
    INFO(plugin << ": " << attempt.finished.err);
    CHECK(attempt.finished.exit_code == 4);
    CHECK(contains(attempt.finished.err, id));
    CHECK(contains(attempt.finished.err, "remedy: "));
    CHECK_FALSE(fs::exists(attempt.out));
  }
}

TEST_CASE("the refusal names the line of the configuration that asked for it") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 2);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const auto finished = tolman::test::tolman({"run", config.string()});  // no fixture path
  CHECK(finished.exit_code == 4);
  CHECK(contains(finished.err, config.string() + ":3:20: odometry.plugin: [plugin/not-found]"));
}

TEST_CASE("plugins that fail before frame 0 leave no run directory") {
  const Attempt constructor("misbehaving", "throws_in_constructor");
  CHECK(constructor.finished.exit_code == 4);
  CHECK(contains(constructor.finished.err, "threw: constructor gives up"));
  CHECK_FALSE(fs::exists(constructor.out));
  const Attempt thrown("misbehaving", "throws_in_configure");
  CHECK(thrown.finished.exit_code == 4);
  CHECK(contains(thrown.finished.err, "configure: threw: configure gives up"));
  const Attempt failed("misbehaving", "fails_in_configure");
  CHECK(failed.finished.exit_code == 3);
  CHECK(contains(failed.finished.err, "speed and direction exclude each other"));
}

TEST_CASE("plugins that fail at frame 3 end with exit code 7; frames 0 to 2 are recorded") {
  for (const char* plugin : {"throws_in_track", "throws_an_integer", "returns_nan",
                             "goes_back_in_time", "answers_another_frame", "revises_the_future"}) {
    const Attempt attempt("misbehaving", plugin);
    INFO(plugin << ": " << attempt.finished.err);
    CHECK(attempt.finished.exit_code == 7);
    CHECK(
        contains(attempt.finished.err, "odometry (" + std::string(plugin) + "), track, frame 3: "));
    const auto provenance = readJson(attempt.out / "run.json");
    CHECK(provenance["status"] == "failed");
    CHECK(provenance["exit_code"] == 7);
    CHECK(provenance["counters"]["frames"] == 3);
    CHECK(fs::exists(attempt.out / "trajectory.tum"));
  }
}

TEST_CASE("on_failure: skip goes on without the frame") {
  const Attempt attempt("misbehaving", "throws_in_track", {"--set", "odometry.on_failure=skip"});
  INFO(attempt.finished.err);
  CHECK(attempt.finished.exit_code == 0);
  const auto counters = readJson(attempt.out / "run.json")["counters"];
  CHECK(counters["frames"] == 6);
  CHECK(counters["skipped"] == 1);
}

TEST_CASE("failures at the end are reported, and the record is whole") {
  const Attempt finish("misbehaving", "throws_in_finish");
  CHECK(finish.finished.exit_code == 7);
  CHECK(readJson(finish.out / "run.json")["counters"]["frames"] == 6);
  const Attempt destructor("misbehaving", "throws_in_destructor");
  CHECK(destructor.finished.exit_code == 0);
  CHECK(contains(readText(destructor.out / "log.txt"), "threw: destructor gives up"));
}
