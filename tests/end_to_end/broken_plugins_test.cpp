// SPDX-License-Identifier: BSD-3-Clause
// Plugins that violate the contract: each gives its message and exit code, and earlier results are
// kept.
#include <catch2/catch.hpp>

#include "end_to_end/fixture_plugins.hpp"
#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

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
        "run",           config.string(),           "--out", out.string(),
        "--plugin-path", kFixturePlugins + library, "--set", "odometry={plugin: " + plugin + "}"};
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

namespace {

struct WrongAnswer {
  const char* plugin;
  const char* message;  ///< after "STAGE (PLUGIN), "
};

/// The run ends with 7 and this message, and what was recorded before can be read.
void expectStopped(const std::string& stage, const WrongAnswer& wrong,
                   const std::string& isolation = "none") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 6);
  const auto out = folder.path() / "run";
  auto arguments = tinyRun(writeTinyConfig(folder.path(), folder.path() / "sequence"), out);
  for (const std::string& word : std::vector<std::string>{
           "--plugin-path", kFixturePlugins + "answer_faults", "--plugin-path",
           kFixturePlugins + "role_faults", "--set",
           stage + "={plugin: " + wrong.plugin + ", isolation: " + isolation + "}"}) {
    arguments.push_back(word);
  }
  const Finished run = tolman::test::tolman(arguments);
  INFO(wrong.plugin << ": " << run.err);
  CHECK(run.exit_code == 7);
  CHECK(contains(run.err, stage + " (" + wrong.plugin + "), " + wrong.message));
  CHECK(tolman::test::tolman({"export", out.string(), "--out", (folder.path() / "e").string()})
            .exit_code == 0);
  const Finished report = tolman::test::tolman({"report", out.string()});
  INFO(report.err);
  CHECK(report.exit_code == 0);
}

}  // namespace

TEST_CASE("answers that the record cannot take, or that break the contract, are not recorded") {
  for (const WrongAnswer& wrong : std::vector<WrongAnswer>{
           {"mirror", "track, frame 3: the rotation of 'T_previous_current' is not orthonormal"},
           {"huge_speed", "track, frame 3: 'v' is larger than a record takes"},
           {"far_revision", "track, frame 3: 'revisions.T_previous_current' is farther than"},
           {"revises_itself", "track, frame 3: revised frame 3, which is not a past frame"},
           {"huge_covariance", "track, frame 3: 'covariance' is larger than 1e+36 m^2"},
           {"negative_dt", "track, frame 3: 'dt' is -3 s"},
           {"negative_tracked", "track, frame 3: 'tracked' is -9"},
           {"negative_variance", "track, frame 3: 'covariance' has a negative variance"},
           {"future_points", "track, frame 3: points of frame 4"},
           {"finishes_the_future", "finish: revised frame 999999"}}) {
    expectStopped("odometry", wrong);
  }
  for (const WrongAnswer& wrong : std::vector<WrongAnswer>{
           {"far_loop", "step, frame 3: 'T_experience_current' is farther than a record takes"},
           {"no_rotation", "step, frame 3: the rotation of 'T_experience_current' is not"},
           {"negative_loop", "step, frame 3: 'covariance' has a negative variance"},
           {"exact_loop", "step, frame 3: 'covariance' is zero"},
           {"array_twice", "arrays, frame 3: array 'a' is given twice"},
           {"array_escape", "arrays, frame 3: the array name 'a\xef\xbf\xbd[31m' is not"},
           {"array_renamed", "arrays, frame 3: array 'b' was not there before"},
           {"array_many", "arrays, frame 3: 3001 arrays; at most 256"}}) {
    expectStopped("cells", wrong);
  }
}

TEST_CASE("answers of isolated stages are checked in the same way") {
  expectStopped("odometry", {"mirror", "track, frame 3: the rotation"}, "process");
  expectStopped("cells", {"far_loop", "step, frame 3: 'T_experience_current' is"}, "process");
  expectStopped("cells", {"array_twice", "arrays, frame 3: array 'a' is given"}, "process");
}

TEST_CASE("without any experience the map gets no figures, and each frame is skipped once") {
  const Attempt attempt("role_faults", "feature_stereo",
                        {"--set", "cells={plugin: fails_always, on_failure: skip}"});
  INFO(attempt.finished.err);
  CHECK(contains(attempt.finished.out, "6 processed, 0 dropped, 6 skipped"));
  const auto metrics = readJson(attempt.out / "metrics.json");
  CHECK(metrics["odometry"]["reason"].is_null());
  CHECK(metrics["map"]["coverage"].is_null());
  CHECK(metrics["map"]["reason"] ==
        "the map has no experience, so its poses are those of odometry");
}

TEST_CASE("an impossible revision is left out and told") {
  const Attempt attempt("answer_faults", "fast_revision");
  INFO(attempt.finished.err);
  CHECK(contains(attempt.finished.err, "the revision of frame 2 has a speed of "));
  CHECK(readJson(attempt.out / "run.json")["counters"]["impossible"] == 3);
  CHECK(readJson(attempt.out / "metrics.json")["odometry"]["path_length_m"].get<double>() < 1000);
}

TEST_CASE("on_failure: skip goes on without the frame") {
  const Attempt attempt("misbehaving", "throws_in_track", {"--set", "odometry.on_failure=skip"});
  INFO(attempt.finished.err);
  CHECK(attempt.finished.exit_code == 0);
  const auto counters = readJson(attempt.out / "run.json")["counters"];
  CHECK(counters["frames"] == 6);
  CHECK(counters["skipped"] == 1);
}

TEST_CASE("a map that fails to tell a pose at the end has failed the run") {
  for (const auto& [plugin, says] :
       {std::pair("forgets_poses", "poseOf, frame 5: not seen"),
        std::pair("loses_poses", "poseOf, frame 3: threw: lost it"),
        std::pair("ends_the_stream", "update, frame 0: answered the end of the stream")}) {
    for (const std::string isolation : {"none", "process"}) {
      const Attempt attempt(
          "role_faults", "feature_stereo",
          {"--set", "map={plugin: " + std::string(plugin) + ", isolation: " + isolation + "}",
           "--set", "cells.plugin=single_experience"});
      INFO(attempt.finished.err);
      CHECK(attempt.finished.exit_code == 7);
      CHECK(contains(attempt.finished.err, says));
    }
  }
}

TEST_CASE("a map that contradicts itself has failed the run, and the record stays whole") {
  for (const auto& [plugin, says] :
       {std::pair("old_version", "update, frame 3: the version of the map decreased"),
        std::pair("no_graph", "the graph has 0 experiences, the last update 4"),
        std::pair("negative_link", "link 0 has a duration of -1 s"),
        std::pair("more_experiences", "the graph has 4 experiences, the last update 11"),
        std::pair("more_links", "the graph has 3 links, the last update 10"),
        std::pair("more_loops", "the graph has 0 loop links, the last update 1"),
        std::pair("placed_elsewhere", "graph: is 5 m and 0 rad from the pose by experience 3 of"),
        std::pair("moved_at_the_end", "poseOf, frame 2: is 5 m and 0 rad from the pose by graph()"),
        std::pair("told_elsewhere",
                  "poseOf, frame 3: is 5 m and 0 rad from the pose by graph()")}) {
    const Attempt attempt(
        "role_faults", "feature_stereo",
        {"--set", "map.plugin=" + std::string(plugin), "--set", "cells.plugin=single_experience"});
    INFO(attempt.finished.err);
    CHECK(attempt.finished.exit_code == 7);
    CHECK(contains(attempt.finished.err, says));
    CHECK_FALSE(contains(attempt.finished.err, "FOREIGN KEY"));
    CHECK(readJson(attempt.out / "run.json")["counters"]["frames"] >= 3);
  }
}

TEST_CASE("frames that break the contract end the run, in the words of the source") {
  const TemporaryFolder folder;
  for (const auto& [plugin, says] :
       {std::pair("half_pair", "next, frame 3: only the left image of a pair"),
        std::pair("no_pixels", "next, frame 3: the left image has 320x120 px and no data"),
        std::pair("narrow_rows", "next, frame 3: the left image has rows of 320 bytes and a"),
        std::pair("reshaped_sensor", "next, frame 3: array 'wheel' changed its shape")}) {
    const Attempt attempt("role_faults", "feature_stereo",
                          {"--set", "source={plugin: " + std::string(plugin) +
                                        ", path: " + folder.path().string() + "}"});
    INFO(attempt.finished.err);
    CHECK(attempt.finished.exit_code == 5);
    CHECK(contains(attempt.finished.err, says));
  }
}

TEST_CASE("frames of a camera that have no image and no reason count as frames without image") {
  const TemporaryFolder folder;
  const Attempt attempt(
      "role_faults", "feature_stereo",
      {"--set", "source={plugin: no_image, path: " + folder.path().string() + "}"});
  INFO(attempt.finished.err);
  CHECK(readJson(attempt.out / "run.json")["counters"]["defects"] == 2);  // frames 3 and 4
}

TEST_CASE("a plugin that offers its state and cannot save it has failed the run") {
  for (const auto& [plugin, says] :
       {std::pair("fails_to_save", "save: threw: no room"),
        std::pair("saves_to_nowhere", "save: left its stream in a failed state")}) {
    for (const std::string isolation : {"none", "process"}) {
      const Attempt attempt(
          "role_faults", "feature_stereo",
          {"--set", "place={plugin: " + std::string(plugin) + ", isolation: " + isolation + "}"});
      INFO(attempt.finished.err);
      CHECK(attempt.finished.exit_code == 7);
      CHECK(contains(attempt.finished.err, says));
      const auto run = readJson(attempt.out / "run.json");
      CHECK(run["status"] == "failed");
      CHECK(run["counters"]["frames"] == 6);
      CHECK(fs::exists(attempt.out / "metrics.json"));
      CHECK_FALSE(fs::exists(attempt.out / "state" / "session.json"));
    }
  }
}

TEST_CASE("failures at the end are reported, and the record is whole") {
  const Attempt finish("misbehaving", "throws_in_finish");
  CHECK(finish.finished.exit_code == 7);
  CHECK(readJson(finish.out / "run.json")["counters"]["frames"] == 6);
  const Attempt destructor("misbehaving", "throws_in_destructor");
  CHECK(destructor.finished.exit_code == 0);
  CHECK(contains(readText(destructor.out / "log.txt"), "threw: destructor gives up"));
}
