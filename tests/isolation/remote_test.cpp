// SPDX-License-Identifier: BSD-3-Clause
// Plugins in processes of their own: they answer as in the host, and their deaths are told.
#include "isolation/remote.hpp"

#include <catch2/catch.hpp>

#include "host/fixture_plugins.hpp"
#include "isolation/remote_roles.hpp"
#include "plugins/stages.hpp"
#include "support/context.hpp"

using namespace tolman;
using namespace tolman::test;

namespace {

isolation::Launch launch(double deadline_s = 60, std::uint64_t memory_mib = 4096) {
  return {{TOLMAN_BINARY_DIR "/bin/tolman", "run-stage"}, deadline_s, memory_mib, 1};
}

plugins::OrRefusal<std::shared_ptr<isolation::Remote>> start(const std::string& library,
                                                             const std::string& id,
                                                             const isolation::Launch& how) {
  auto manifests = plugins::readManifests(fixtureFile(library));
  REQUIRE(std::holds_alternative<std::vector<plugins::Manifest>>(manifests));
  for (const auto& manifest : std::get<std::vector<plugins::Manifest>>(manifests)) {
    if (manifest.id == id) return isolation::Remote::start(manifest, how);
  }
  FAIL("no plugin " << id << " in " << library);
  return plugins::Refusal{};
}

/// A stage of a fixture plugin in its own process, configured.
template <class Stage>
struct Isolated {
  Isolated(const std::string& library, const std::string& id,
           const isolation::Launch& how = launch(), bool restart = false) {
    auto started = start(library, id, how);
    REQUIRE(std::holds_alternative<std::shared_ptr<isolation::Remote>>(started));
    remote = std::get<std::shared_ptr<isolation::Remote>>(started);
    auto created = isolation::instantiate(remote, "stage");
    REQUIRE(std::holds_alternative<std::unique_ptr<plugins::Instance>>(created));
    stage =
        std::make_unique<Stage>(std::move(std::get<std::unique_ptr<plugins::Instance>>(created)));
    if (restart) REQUIRE(remote->enableRestart());
    REQUIRE(stage->instance().configure(context).isOk());
  }
  TestContext context;
  std::shared_ptr<isolation::Remote> remote;
  std::unique_ptr<Stage> stage;
};

Frame frameAt(std::int64_t k) {
  Frame frame;
  frame.frame = k;
  frame.stamp_ns = k * 100'000'000;
  return frame;
}

/// Drives odometry until it fails, at most ten frames.
Status drive(plugins::OdometryStage& stage, Motion& motion) {
  for (std::int64_t k = 0; k < 10; ++k) {
    motion = Motion();
    Status status = stage.track(frameAt(k), motion);
    if (!status.isOk()) return status;
  }
  return Status::ok();
}

std::string messageOf(const std::string& library, const std::string& id,
                      const isolation::Launch& how = launch()) {
  const Isolated<plugins::OdometryStage> isolated(library, id, how);
  Motion motion;
  return drive(*isolated.stage, motion).message();
}

}  // namespace

TEST_CASE("schema and answers come from the process as they would in the host") {
  Isolated<plugins::OdometryStage> isolated("steady", "steady");
  REQUIRE(isolated.remote->schema().size() == 1);
  CHECK(isolated.remote->schema()[0].name == "speed");
  CHECK(isolated.remote->schema()[0].doc == "Speed straight ahead.");
  Motion motion;
  CHECK(drive(*isolated.stage, motion).isOk());
  CHECK(motion.T_previous_current.translation().z() == 10 * 0.1);
  CHECK(motion.state == TrackingState::Tracking);
  CHECK(isolated.stage->instance().destroy().isOk());
}

TEST_CASE("an exception is told as in the host") {
  CHECK(messageOf("misbehaving", "throws_in_track") ==
        "stage (throws_in_track), track, frame 3: threw: track gives up");
  CHECK(messageOf("misbehaving", "throws_an_integer") ==
        "stage (throws_an_integer), track, frame 3: threw something that is no std::exception");
}

TEST_CASE("a death is told with plugin, call, frame and signal") {
  CHECK(messageOf("guests", "segfault") ==
        "stage (segfault), track, frame 3: its process died of SIGSEGV (Segmentation fault)");
  CHECK(messageOf("guests", "abort_") ==
        "stage (abort_), track, frame 3: its process died of SIGABRT (Aborted)");
  CHECK(messageOf("guests", "exit_") ==
        "stage (exit_), track, frame 3: its process ended the process itself (exit code 0)");
}

TEST_CASE("who does not return is ended at the deadline") {
  CHECK(messageOf("guests", "loop_forever", launch(0.3)) ==
        "stage (loop_forever), track, frame 3: did not return within 0.3 s; its process was ended");
}

TEST_CASE("who takes too much memory is told so") {
  if (std::string(TOLMAN_SANITIZER) != "none") return;  // sanitizers take more than any limit
  CHECK(messageOf("guests", "eat_memory", launch(60, 512)) ==
        "stage (eat_memory), track, frame 3: threw: std::bad_alloc; isolation.memory_limit is 512 "
        "MiB");
}

TEST_CASE("after its death a stage without restart only says so") {
  Isolated<plugins::OdometryStage> isolated("guests", "segfault");
  Motion motion;
  REQUIRE_FALSE(drive(*isolated.stage, motion).isOk());
  CHECK(isolated.stage->track(frameAt(4), motion).message() ==
        "stage (segfault), track, frame 4: its process is gone, since it died of SIGSEGV "
        "(Segmentation fault)");
}

TEST_CASE("libraries that cannot be opened are refused with their id, the host alive") {
  CHECK(refusalOf(start("missing_symbol", "missing_symbol", launch())).id == "plugin/load-failed");
  const auto died = start("dies_on_load", "dies_on_load", launch());
  CHECK(refusalOf(died).id == "plugin/died");
  CHECK(refusalOf(died).message.find("its process died of SIGABRT") != std::string::npos);
}

TEST_CASE("a restarted place knows what it knew, but for the fatal frame") {
  Isolated<plugins::PlaceStage> mortal("strangers", "dies_once", launch(), true);
  Isolated<plugins::PlaceStage> model("strangers", "keeper");
  for (std::int64_t k = 0; k < 45; ++k) {
    PlaceObservation seen;
    const Status status = mortal.stage->observe(frameAt(k), nullptr, seen);
    INFO("frame " << k << ": " << status.message());
    CHECK(status.isOk() == (k != 25));
    if (k == 25) {
      CHECK(status.message() ==
            "stage (dies_once), observe, frame 25: its process died of SIGABRT (Aborted); a new "
            "process takes over");
      continue;
    }
    PlaceObservation expected;
    REQUIRE(model.stage->observe(frameAt(k), nullptr, expected).isOk());
    CHECK(seen.template_id == expected.template_id);
    CHECK(seen.recognition == expected.recognition);
  }
  CHECK(mortal.context.log ==
        std::vector<std::string>{"a new process has taken over (1 of 10 restarts)"});
}

TEST_CASE("nobody is restarted for ever") {
  Isolated<plugins::PlaceStage> mortal("strangers", "dies_often", launch(), true);
  int answered = 0;
  Status last;
  for (std::int64_t k = 0; k < 40; ++k) {
    PlaceObservation seen;
    last = mortal.stage->observe(frameAt(k), nullptr, seen);
    answered += last.isOk() ? 1 : 0;
  }
  CHECK(answered == 11);  // even frames of the first process and of ten more
  CHECK(last.message().find("its process is gone, since it died of SIGABRT") != std::string::npos);
}

TEST_CASE("who cannot save what it knows cannot be restarted") {
  auto places = start("strangers", "skips_template_ids", launch());
  auto& remote = std::get<std::shared_ptr<isolation::Remote>>(places);
  REQUIRE_FALSE(remote->create().has_value());
  CHECK_FALSE(remote->enableRestart());
}

TEST_CASE("a restarted odometry without memory predicts; it does not claim to stand still") {
  Isolated<plugins::OdometryStage> isolated("guests", "segfault", launch(), true);
  Motion motion;
  REQUIRE_FALSE(drive(*isolated.stage, motion).isOk());
  motion = Motion();
  REQUIRE(isolated.stage->track(frameAt(4), motion).isOk());
  CHECK(motion.T_previous_current.translation().z() > 0);
}

TEST_CASE("saved states cross the border both ways") {
  Isolated<plugins::PlaceStage> first("strangers", "keeper");
  PlaceObservation seen;
  for (std::int64_t k = 0; k < 15; ++k) {
    REQUIRE(first.stage->observe(frameAt(k), nullptr, seen).isOk());
  }
  std::stringstream state;
  REQUIRE(first.stage->instance().state()->save(state).isOk());
  Isolated<plugins::PlaceStage> second("strangers", "keeper");
  REQUIRE(second.stage->instance().state()->load(state).isOk());
  second.stage->expect(-1);  // what it knows is its own affair now
  REQUIRE(second.stage->observe(frameAt(15), nullptr, seen).isOk());
  CHECK(seen.template_id == 1);
  std::istringstream damaged("no state");
  CHECK(second.stage->instance().state()->load(damaged).code() == StatusCode::InvalidInput);
}
