// SPDX-License-Identifier: BSD-3-Clause
// The engine in another program: the code of docs/embed.md compiles, runs, and gives the same
// results as `tolman run`.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

#include "end_to_end/tiny_kitti.hpp"
#include "engine/run.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman;
using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

const std::string kPlugins = inBuild("plugins");
const std::string kFixtures = inBuild("tests/fixtures/plugins/");

struct NeverCancelled : Cancellation {
  bool requested() const override { return false; }
};

struct Tiny {
  Tiny() {
    writeTinyKitti(folder.path() / "sequence", 20);
    options.config = writeTinyConfig(folder.path(), folder.path() / "sequence").string();
    options.plugin_paths = {kPlugins, kFixtures + "steady", kFixtures + "misbehaving"};
  }
  engine::Outcome execute() {
    const NeverCancelled cancellation;
    engine::RunLog log(true);
    const engine::SteadyClock clock;
    engine::Run run(log, clock, cancellation, {.out = out});
    return run.execute(engine::checkSystem(options));
  }
  TemporaryFolder folder;
  engine::SystemOptions options;
  fs::path out = folder.path() / "run";
};

std::optional<engine::FailureKind> kindOfRefusal(const engine::SystemOptions& options) {
  try {
    (void)engine::checkSystem(options);
  } catch (const engine::Failure& failure) {
    return failure.kind;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("docs/embed.md shows the example as it is compiled") {
  const std::string page = readText(inSource("docs/embed.md"));
  const std::string code = readText(inSource("tests/engine/embed_example.cpp"));
  CHECK(contains(page, code.substr(code.find("#include"))));
}

TEST_CASE("the example gives the results of the command line") {
  const Tiny tiny;
  const std::string search = kPlugins + ":" + kFixtures + "steady";
  REQUIRE(::setenv("TOLMAN_PLUGIN_PATH", search.c_str(), 1) == 0);
  const Finished example =
      test::run({TOLMAN_EMBED_EXAMPLE, tiny.options.config, tiny.out.string()});
  ::unsetenv("TOLMAN_PLUGIN_PATH");
  INFO(example.out << example.err);
  CHECK(example.exit_code == 0);
  CHECK(contains(example.out, "20 frames, "));
  const fs::path reference = tiny.folder.path() / "reference";
  REQUIRE(test::tolman(tinyRun(tiny.options.config, reference)).exit_code == 0);
  CHECK(readText(tiny.out / "results.sha256") == readText(reference / "results.sha256"));
  CHECK_FALSE(readJson(tiny.out / "run.json").contains("exit_code"));  // it has no command line
}

TEST_CASE("an outcome has counters, figures, times and the directory") {
  Tiny tiny;
  const engine::Outcome outcome = tiny.execute();
  CHECK_FALSE(outcome.failure);
  CHECK_FALSE(outcome.interrupted);
  CHECK(outcome.directory == tiny.out);
  CHECK(outcome.counters.frames == 20);
  CHECK_FALSE(outcome.counters.lost_at_end);
  CHECK(outcome.wall_s > 0);
  REQUIRE(outcome.metrics);
  CHECK(outcome.metrics->frames == 20);
  CHECK(outcome.metrics->counts.experiences == outcome.counters.experiences);
}

TEST_CASE("failures carry kind and stage, and not only words") {
  Tiny tiny;
  SECTION("the configuration") {
    tiny.options.overrides = {"odometry.sped=3"};
    CHECK(kindOfRefusal(tiny.options) == engine::FailureKind::Configuration);
  }
  SECTION("a plugin that is not there") {
    tiny.options.overrides = {"map.plugin=atlas"};
    CHECK(kindOfRefusal(tiny.options) == engine::FailureKind::Plugin);
  }
  SECTION("a plugin that fails while running; what was done before is recorded") {
    tiny.options.overrides = {"odometry.plugin=throws_in_track", "odometry.name=legs"};
    const engine::Outcome outcome = tiny.execute();
    REQUIRE(outcome.failure);
    CHECK(outcome.failure->kind == engine::FailureKind::Stage);
    CHECK(outcome.failure->stage == "legs");
    CHECK(outcome.counters.frames == 3);
    CHECK(outcome.metrics);
    const auto file = readJson(tiny.out / "run.json");
    CHECK(file["status"] == "failed");
    CHECK(file["failure"]["kind"] == "stage");
    CHECK(file["failure"]["stage"] == "legs");
  }
  SECTION("the data") {
    fs::remove(tiny.folder.path() / "sequence/image_0/000007.png");
    const engine::Outcome outcome = tiny.execute();
    REQUIRE(outcome.failure);
    CHECK(outcome.failure->kind == engine::FailureKind::Dataset);
    CHECK(outcome.failure->stage == "source");
  }
  SECTION("data in the folder of a run that would be replaced") {
    tiny.out = tiny.folder.path() / "sequence";
    const engine::Outcome outcome = tiny.execute();
    REQUIRE(outcome.failure);
    CHECK(outcome.failure->kind == engine::FailureKind::Record);
    CHECK(contains(outcome.failure->message, "holds data that the run reads"));
    CHECK(fs::exists(tiny.out / "image_0/000000.png"));
  }
  SECTION("the directory") {
    fs::create_directories(tiny.out);
    std::ofstream(tiny.out / "letter.txt") << "not a run";
    const engine::Outcome outcome = tiny.execute();
    REQUIRE(outcome.failure);
    CHECK(outcome.failure->kind == engine::FailureKind::Record);
    CHECK(outcome.directory.empty());
  }
  SECTION("the map of an earlier run") {
    tiny.options.overrides = {"continue=" + tiny.folder.path().string()};
    const engine::Outcome outcome = tiny.execute();
    REQUIRE(outcome.failure);
    CHECK(outcome.failure->kind == engine::FailureKind::Continuation);
  }
}
