// SPDX-License-Identifier: BSD-3-Clause
// Plugins in a separate process: equal answers, and failures when the process ends.
#include "host/remote_plugin.hpp"

#include <catch2/catch.hpp>

#include "host/fixture_plugins.hpp"
#include "host/remote_plugin.hpp"
#include "host/stages.hpp"
#include "support/context.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman;
using namespace tolman::test;

namespace {

host::LaunchOptions launch(double deadline_s = 60, std::uint64_t memory_mib = 4096) {
  return {{inBuild("bin/tolman"), "run-stage"}, deadline_s, memory_mib, 1};
}

std::shared_ptr<host::RemotePlugin> startFrom(const std::filesystem::path& library,
                                              const std::string& id,
                                              const host::LaunchOptions& how) {
  return host::RemotePlugin::start(host::readManifest(library, id), how);
}

std::shared_ptr<host::RemotePlugin> start(const std::string& library, const std::string& id,
                                          const host::LaunchOptions& how) {
  return startFrom(fixtureFile(library), id, how);
}

/// A stage of a fixture plugin in its own process, configured.
template <class Stage>
struct Isolated {
  Isolated(const std::string& library, const std::string& id,
           const host::LaunchOptions& how = launch(), bool restart = false)
      : Isolated(start(library, id, how), restart) {}
  Isolated(std::shared_ptr<host::RemotePlugin> plugin, bool restart) : remote(std::move(plugin)) {
    stage = std::make_unique<Stage>(host::instantiate(remote, "stage"));
    if (restart) REQUIRE(remote->enableRestart());
    REQUIRE(stage->instance().configure(context).isOk());
  }
  TestContext context;
  std::shared_ptr<host::RemotePlugin> remote;
  std::unique_ptr<Stage> stage;
};

Frame frameAt(std::int64_t k) {
  Frame frame;
  frame.frame = k;
  frame.stamp_ns = k * 100'000'000;
  return frame;
}

/// Drives odometry until it fails, at most ten frames.
Status drive(host::OdometryStage& stage, Motion& motion) {
  for (std::int64_t k = 0; k < 10; ++k) {
    motion = Motion();
    Status status = stage.track(frameAt(k), motion);
    if (!status.isOk()) return status;
  }
  return Status::ok();
}

std::string messageOf(const std::string& library, const std::string& id,
                      const host::LaunchOptions& how = launch()) {
  const Isolated<host::OdometryStage> isolated(library, id, how);
  Motion motion;
  return drive(*isolated.stage, motion).message();
}

}  // namespace

TEST_CASE("descriptions of arrays and the address of a page come from the process") {
  Isolated<host::ObserverStage> isolated("snapshot_log", "snapshot_log");
  host::Instance& instance = isolated.stage->instance();
  std::vector<ArrayInfo> arrays(1);
  REQUIRE(instance.describe(arrays).isOk());
  REQUIRE(arrays.size() == 2);  // appended
  CHECK(arrays[1].name == "rates");
  CHECK(arrays[1].kind == ArrayKind::Activity);
  REQUIRE(arrays[1].axes.size() == 1);
  CHECK(arrays[1].axes[0].unit == "rad");
  CHECK(arrays[1].axes[0].period == 6.5);
  CHECK(instance.url().value() == "http://snapshot_log/");
  Isolated<host::OdometryStage> steady("steady", "steady");
  CHECK(steady.stage->instance().url().status().code() == StatusCode::Unsupported);
  std::vector<ArrayInfo> none;
  CHECK(steady.stage->instance().describe(none).isOk());
  CHECK(none.empty());
}

TEST_CASE("the cameras of an unrectified source come from the process, finite ones only") {
  Isolated<host::SourceStage> isolated("raw_pair", "raw_pair");
  SourceInfo info;
  REQUIRE(isolated.stage->info(info).isOk());
  RawRig rig;
  REQUIRE(isolated.stage->instance().rawRig(rig).isOk());
  REQUIRE(rig.cameras.size() == 2);
  CHECK(rig.cameras[1].model == LensModel::RadialTangential);
  CHECK(rig.cameras[1].pinhole.fy == 41);
  CHECK(rig.cameras[1].distortion[0] == -0.1);
  CHECK(rig.cameras[1].T_reference_camera.translation().x() == 0.25);
  Isolated<host::OdometryStage> steady("steady", "steady");
  CHECK(steady.stage->instance().rawRig(rig).isOk());
  CHECK(rig.cameras.empty());
}

TEST_CASE("schema and answers come from the process as they would in the host") {
  Isolated<host::OdometryStage> isolated("steady", "steady");
  REQUIRE(isolated.remote->schema().size() == 1);
  CHECK(isolated.remote->schema()[0].name == "speed");
  CHECK(isolated.remote->schema()[0].doc == "Speed straight ahead.");
  Motion motion;
  CHECK(drive(*isolated.stage, motion).isOk());
  CHECK(motion.T_previous_current.translation().z() == 10 * 0.1);
  CHECK(motion.state == TrackingState::Tracking);
  CHECK(isolated.stage->instance().destroy().isOk());
}

TEST_CASE("an exception is reported as in the host") {
  CHECK(messageOf("misbehaving", "throws_in_track") ==
        "stage (throws_in_track), track, frame 3: threw: track gives up");
  CHECK(messageOf("misbehaving", "throws_an_integer") ==
        "stage (throws_an_integer), track, frame 3: threw something that is not a std::exception");
}

TEST_CASE("a failure while arrays are read is reported once") {
  Isolated<host::CellsStage> isolated("role_faults", "array_throws");
  std::vector<NamedArray> arrays;
  Motion motion;
  motion.frame = 3;
  Decision decision;
  REQUIRE(isolated.stage->step(motion, {}, decision).isOk());
  CHECK(isolated.stage->instance().arrays(3, arrays).message() ==
        "stage (array_throws), arrays, frame 3: threw: no numbers");
}

TEST_CASE("a crash is reported with plugin, call, frame and signal") {
  CHECK(messageOf("process_faults", "segfault") ==
        "stage (segfault), track, frame 3: its process died of SIGSEGV (Segmentation fault)");
  CHECK(messageOf("process_faults", "abort_") ==
        "stage (abort_), track, frame 3: its process died of SIGABRT (Aborted)");
  CHECK(messageOf("process_faults", "exit_") ==
        "stage (exit_), track, frame 3: its process exited with code 0");
}

TEST_CASE("a call that exceeds the deadline ends the process") {
  CHECK(messageOf("process_faults", "loop_forever", launch(0.3)) ==
        "stage (loop_forever), track, frame 3: its process did not return within 0.3 s and "
        "was killed");
}

TEST_CASE("memory beyond the limit is reported") {
  if (std::string(TOLMAN_SANITIZER) != "none") return;  // sanitizers take more than any limit
  CHECK(messageOf("process_faults", "eat_memory", launch(60, 512)) ==
        "stage (eat_memory), track, frame 3: threw: std::bad_alloc (out of memory: `ulimit -v`, or "
        "that of the machine); isolation.memory_limit is 512 MiB");
}

TEST_CASE("without restart, later calls fail with the reason of the exit") {
  Isolated<host::OdometryStage> isolated("process_faults", "segfault");
  Motion motion;
  REQUIRE_FALSE(drive(*isolated.stage, motion).isOk());
  CHECK(isolated.stage->track(frameAt(4), motion).message() ==
        "stage (segfault), track, frame 4: its process has ended: it died of SIGSEGV "
        "(Segmentation fault)");
}

TEST_CASE("libraries that cannot be opened are refused with an id") {
  CHECK(REFUSAL_OF(start("missing_symbol", "missing_symbol", launch())).id == "plugin/load-failed");
  const host::Refusal died = REFUSAL_OF(start("dies_on_load", "dies_on_load", launch()));
  CHECK(died.id == "plugin/died");
  CHECK(died.message.find("its process died of SIGABRT") != std::string::npos);
}

TEST_CASE("a library that opens too slowly is refused with the limit's name") {
  const host::Refusal late = REFUSAL_OF(start("steady", "steady", launch(1e-9)));
  CHECK(late.remedy.ends_with("within `isolation.deadline` and `isolation.memory_limit`"));
}

TEST_CASE("a restarted place recognition has its state, except for the frame of the crash") {
  Isolated<host::PlaceStage> crashing("role_faults", "dies_once", launch(), true);
  Isolated<host::PlaceStage> reference("role_faults", "keeper");
  for (std::int64_t k = 0; k < 45; ++k) {
    PlaceObservation seen;
    const Status status = crashing.stage->observe(frameAt(k), nullptr, seen);
    INFO("frame " << k << ": " << status.message());
    CHECK(status.isOk() == (k != 25));
    if (k == 25) {
      CHECK(status.message() ==
            "stage (dies_once), observe, frame 25: its process died of SIGABRT (Aborted); a new "
            "process will be started");
      continue;
    }
    PlaceObservation expected;
    REQUIRE(reference.stage->observe(frameAt(k), nullptr, expected).isOk());
    CHECK(seen.template_id == expected.template_id);
    CHECK(seen.recognition == expected.recognition);
  }
  CHECK(crashing.context.log ==
        std::vector<std::string>{"a new process was started (restart 1 of 10)"});
}

TEST_CASE("the number of restarts is limited") {
  Isolated<host::PlaceStage> crashing("role_faults", "dies_often", launch(), true);
  int answered = 0;
  Status last;
  for (std::int64_t k = 0; k < 40; ++k) {
    PlaceObservation seen;
    last = crashing.stage->observe(frameAt(k), nullptr, seen);
    answered += last.isOk() ? 1 : 0;
  }
  CHECK(answered == 11);  // even frames of the first process and of ten more
  CHECK(last.message().find("its process has ended: it died of SIGABRT") != std::string::npos);
}

TEST_CASE("place recognition without saved state cannot be restarted") {
  auto places = start("role_faults", "skips_template_ids", launch());
  auto& remote = places;
  remote->create();
  CHECK_FALSE(remote->enableRestart());
}

TEST_CASE("a restarted odometry without saved state fails until it finds a motion") {
  Isolated<host::OdometryStage> isolated("process_faults", "begins_anew", launch(), true);
  Motion motion;
  REQUIRE_FALSE(drive(*isolated.stage, motion).isOk());
  motion = Motion();
  CHECK(isolated.stage->track(frameAt(4), motion).message().find("found no motion yet") !=
        std::string::npos);
  CHECK(isolated.stage->track(frameAt(5), motion).isOk());
}

TEST_CASE("saved state is sent to and from the process") {
  Isolated<host::PlaceStage> first("role_faults", "keeper");
  PlaceObservation seen;
  for (std::int64_t k = 0; k < 15; ++k) {
    REQUIRE(first.stage->observe(frameAt(k), nullptr, seen).isOk());
  }
  std::stringstream state;
  REQUIRE(first.stage->instance().state()->save(state).isOk());
  Isolated<host::PlaceStage> second("role_faults", "keeper");
  REQUIRE(second.stage->instance().state()->load(state).isOk());
  second.stage->resetChecks(-1);  // the number of templates is not known after load()
  REQUIRE(second.stage->observe(frameAt(15), nullptr, seen).isOk());
  CHECK(seen.template_id == 1);
  std::istringstream damaged("no state");
  CHECK(second.stage->instance().state()->load(damaged).code() == StatusCode::InvalidInput);
}
