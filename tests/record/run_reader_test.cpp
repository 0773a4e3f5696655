// SPDX-License-Identifier: BSD-3-Clause
#include "record/run_reader.hpp"

#include <algorithm>

#include "record/by_hand.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

std::string refusal(const std::filesystem::path& folder) {
  const auto reader = RunReader::open(folder);
  REQUIRE_FALSE(reader.isOk());
  CHECK(reader.status().code() == StatusCode::InvalidInput);
  const std::string message = reader.status().message();
  REQUIRE(message.find(folder.string()) == 0);
  return message.substr(folder.string().size());
}

void recordFrames(const std::filesystem::path& folder, std::int64_t frames) {
  auto recorder = Recorder::open(folder).value();
  for (std::int64_t i = 0; i < frames; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  REQUIRE(recorder->close().isOk());
}

}  // namespace

TEST_CASE("odometry is composed from the last revisions") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  Eigen::Isometry3d two = Eigen::Isometry3d::Identity();
  two.translation().z() = 2;
  Eigen::Isometry3d three = Eigen::Isometry3d::Identity();
  three.translation().z() = 3;
  for (std::int64_t i = 0; i < 4; ++i) {
    const Frame frame = test::frameAt(i);
    Motion motion = test::motionAt(i);  // 1 m each
    if (i == 3) motion.revisions = {{1, two, Matrix6d::Zero()}, {1, three, Matrix6d::Zero()}};
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    REQUIRE(recorder->snapshot(snapshot).isOk());
  }
  REQUIRE(recorder->revisions({{3, two, Matrix6d::Zero()}}).isOk());
  REQUIRE(recorder->close().isOk());
  const auto poses = RunReader::open(folder.path()).value()->odometry().value();
  REQUIRE(poses.size() == 4);
  CHECK(poses[0].T_world_camera.translation().z() == 0);
  CHECK(poses[1].T_world_camera.translation().z() == 3);
  CHECK(poses[2].T_world_camera.translation().z() == 4);
  CHECK(poses[3].T_world_camera.translation().z() == 6);
  CHECK(poses[3].stamp_ns == 1'300'000'000);
}

namespace {

/// Records one frame for each state, with sessions that begin at `beginnings`; `+` for a pose that
/// counts as tracked, `-` for another.
std::string trackedPoses(const std::vector<TrackingState>& states,
                         const std::vector<std::int64_t>& beginnings) {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  std::int64_t i = 0;
  for (const TrackingState state : states) {
    const auto session = std::ranges::find(beginnings, i) - beginnings.begin();
    if (session < std::ssize(beginnings)) {
      REQUIRE(recorder->session({session, i, "part", "made up"}).isOk());
    }
    const Frame frame = test::frameAt(i);
    Motion motion = test::motionAt(i++);
    motion.state = state;
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    REQUIRE(recorder->snapshot(snapshot).isOk());
  }
  REQUIRE(recorder->close().isOk());
  std::string tracked;
  const auto reader = RunReader::open(folder.path()).value();
  for (const auto& pose : reader->odometry().value()) tracked += pose.tracked ? '+' : '-';
  return tracked;
}

}  // namespace

TEST_CASE("poses without tracking are marked; the last before the first track is its origin") {
  using enum TrackingState;
  CHECK(trackedPoses({Initialising, Initialising, Tracking, Lost, Lost, Tracking, Initialising,
                      Tracking, Initialising},
                     {}) == "-++--+-+-");
  CHECK(trackedPoses({Initialising, Lost, Lost, Tracking, Lost, Tracking}, {}) == "--++-+");
  CHECK(trackedPoses({Tracking, Tracking}, {}) == "++");
  CHECK(trackedPoses({Lost, Initialising}, {}) == "--");
}

TEST_CASE("each session has an origin of its own") {
  using enum TrackingState;
  CHECK(trackedPoses({Initialising, Tracking, Lost, Initialising, Lost, Tracking}, {0, 3}) ==
        "++--++");
  CHECK(trackedPoses({Initialising, Lost, Tracking, Tracking}, {0, 2}) == "--++");
}

TEST_CASE("the map's trajectory moves with its experiences") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  for (std::int64_t i = 0; i < 3; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  REQUIRE(recorder->graph({1, {test::experienceAt(0, 0, 10)}, {}, {}}).isOk());
  REQUIRE(recorder->close().isOk());
  const auto reader = RunReader::open(folder.path()).value();
  const auto poses = reader->map().value();
  REQUIRE(poses.size() == 3);
  CHECK(poses[2].T_world_camera.translation().z() == 12);
  CHECK(reader->truth().value().empty());
}

TEST_CASE("trajectories and graph are computed once, and do not change with later frames") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  for (std::int64_t i = 0; i < 3; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  REQUIRE(recorder->commit().isOk());
  const auto reader = RunReader::open(folder.path()).value();
  const auto* poses = &reader->odometry().value();
  const auto* graph = &reader->graph().value();
  REQUIRE(test::recordFrame(*recorder, 3).isOk());
  REQUIRE(recorder->close().isOk());
  CHECK(&reader->odometry().value() == poses);
  CHECK(&reader->graph().value() == graph);
  CHECK(poses->size() == 3);
  CHECK(reader->map().value().size() == 3);  // asked first after the run went on
  CHECK(RunReader::open(folder.path()).value()->map().value().size() == 4);
}

TEST_CASE("the scale is known, or not, as the last motion says") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  const auto known = [&] {
    REQUIRE(recorder->commit().isOk());
    return RunReader::open(folder.path()).value()->scaleKnown().value();
  };
  CHECK(known());  // nothing speaks against it
  for (const bool metric : {true, false, true}) {
    const std::int64_t index =
        std::stoll(test::queryByHand(folder.path(), "SELECT count(*) FROM frame").at(0));
    const Frame frame = test::frameAt(index);
    Motion motion = test::motionAt(index);
    motion.scale_known = metric;
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    REQUIRE(recorder->snapshot(snapshot).isOk());
    CHECK(known() == metric);
  }
}

TEST_CASE("which scale tracked motions have, and whether they have both") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  const auto record = [&](std::int64_t index, TrackingState state, bool metric) {
    const Frame frame = test::frameAt(index);
    Motion motion = test::motionAt(index);
    motion.state = state;
    motion.scale_known = metric;
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    REQUIRE(recorder->snapshot(snapshot).isOk());
  };
  record(0, TrackingState::Initialising, true);
  record(1, TrackingState::Tracking, false);
  record(2, TrackingState::Lost, true);
  record(3, TrackingState::Tracking, true);
  REQUIRE(recorder->close().isOk());
  const auto reader = RunReader::open(folder.path()).value();
  CHECK_FALSE(reader->lastScale(1).value());
  for (const std::int64_t end : {2, 3}) {
    REQUIRE(reader->lastScale(end).value());
    CHECK(reader->lastScale(end).value()->frame == 1);
    CHECK_FALSE(reader->lastScale(end).value()->is_known);
  }
  CHECK(reader->lastScale(4).value()->is_known);
  CHECK(reader->mixesScales(0).value());
  CHECK_FALSE(reader->mixesScales(2).value());
}

TEST_CASE("the truth is that of the frames that have one") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  for (std::int64_t i = 0; i < 4; ++i) {
    Frame frame = test::frameAt(i);
    frame.has_truth = i % 2 == 1;
    frame.T_world_camera_truth.translation().x() = static_cast<double>(i);
    Snapshot snapshot;
    snapshot.frame = &frame;
    REQUIRE(recorder->snapshot(snapshot).isOk());
  }
  REQUIRE(recorder->close().isOk());
  const auto truth = RunReader::open(folder.path()).value()->truth().value();
  REQUIRE(truth.size() == 2);
  CHECK(truth[1].frame == 3);
  CHECK(truth[1].stamp_ns == 1'300'000'000);
  CHECK(truth[1].T_world_camera.translation().x() == 3);
}

TEST_CASE("totals count frames, novel views and loop decisions") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  for (std::int64_t i : {0, 1, 4}) {  // realtime: frames 2 and 3 were dropped
    const Frame frame = test::frameAt(i);
    PlaceObservation place;
    place.frame = i;
    place.recognition = i == 1 ? Recognition::Familiar : Recognition::Novel;
    Decision decision;
    decision.frame = i;
    if (i == 4) decision.action = Action::CloseLoop;
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.place = &place;
    snapshot.decision = &decision;
    REQUIRE(recorder->snapshot(snapshot).isOk());
  }
  REQUIRE(recorder->commit().isOk());
  const RunTotals totals = RunReader::open(folder.path()).value()->totals().value();
  CHECK(totals.frames == 3);
  CHECK(totals.templates == 2);
  CHECK(totals.loop_decisions == 1);
}

TEST_CASE("what is no run is refused by name") {
  const test::TemporaryFolder folder;
  CHECK(refusal(folder.path()) ==
        ": is no run directory, it holds no run.sqlite; give the folder that a run has written");
  std::ofstream(folder.path() / "run.sqlite")
      << "this is a letter, not a database at all, and long "
         "enough to have a header of its own";
  CHECK(refusal(folder.path()) ==
        "/run.sqlite: file is not a database; the file is damaged or is no run database");
  std::ofstream(folder.path() / "run.sqlite", std::ios::trunc);
  CHECK(refusal(folder.path()) == "/run.sqlite: is no run database; it has no table `run`");
}

TEST_CASE("the links that the map has rejected are marked, whatever their weight") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  REQUIRE(test::recordFrame(*recorder, 0).isOk());
  MapGraph graph{1, {test::experienceAt(0, 0, 0), test::experienceAt(1, 0, 1)}, {}, {}};
  for (std::int64_t id = 0; id < 4; ++id) {
    graph.links.push_back(test::linkBetween(id, 0, 1, 0));
    graph.links.back().kind = id == 0 ? LinkKind::Odometry : LinkKind::Loop;
    graph.links.back().weight = id == 3 ? 1 : 0.01;
  }
  graph.rejected = {1, 2};
  REQUIRE(recorder->graph(graph).isOk());
  graph.rejected = {1, 3};  // a verdict may change while the link stays the same
  REQUIRE(recorder->graph(graph).isOk());
  REQUIRE(recorder->close().isOk());
  CHECK(RunReader::open(folder.path()).value()->graph().value().rejected == graph.rejected);
}

TEST_CASE("descriptions of arrays come back as they were") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  RunInfo run;
  run.arrays = {{"grid.activity",
                 ArrayKind::Activity,
                 "Hz",
                 "rates",
                 "",
                 {{"x", "m", 0.25, 0.5, 10, {}}, {"y", "m", 0, 0.1, 0, {"a \"b\"", ""}}}},
                {"grid.bump", ArrayKind::Bump, "", "", "grid.activity", {}}};
  REQUIRE(recorder->begin(run).isOk());
  REQUIRE(recorder->close().isOk());
  const auto infos = RunReader::open(folder.path()).value()->arrayInfos().value();
  REQUIRE(infos.size() == 2);
  CHECK(infos[0].unit == "Hz");
  REQUIRE(infos[0].axes.size() == 2);
  CHECK(infos[0].axes[0].period == 10);
  CHECK(infos[0].axes[0].first == 0.25);
  CHECK(infos[0].axes[1].step == 0.1);
  CHECK(infos[0].axes[1].labels == run.arrays[0].axes[1].labels);
  CHECK(infos[1].kind == ArrayKind::Bump);
  CHECK(infos[1].population == "grid.activity");
  test::queryByHand(folder.path(), "UPDATE array_info SET axes = '[{}]'");
  CHECK(RunReader::open(folder.path()).value()->arrayInfos().status().code() ==
        StatusCode::InvalidInput);
}

TEST_CASE("another schema version is refused") {
  for (const std::string version : {"4", "99"}) {
    const test::TemporaryFolder folder;
    recordFrames(folder.path(), 2);
    test::queryByHand(folder.path(),
                      "UPDATE run SET value = '" + version + "' WHERE key = 'schema_version'");
    CHECK(refusal(folder.path()) == "/run.sqlite: has schema version " + version +
                                        ", this program reads 6; run again to record it anew");
  }
}

TEST_CASE("a graph with holes is refused, not read past its end") {
  const test::TemporaryFolder folder;
  recordFrames(folder.path(), 2);
  test::queryByHand(folder.path(), "UPDATE experience SET id = 5");
  const auto reader = RunReader::open(folder.path()).value();
  CHECK(reader->graph().status().message() ==
        (folder.path() / "run.sqlite").string() + ": experience 0 is missing");
  CHECK_FALSE(reader->map().isOk());
}

TEST_CASE("frames that were dropped at the end were given, too") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  REQUIRE(recorder->begin(RunInfo()).isOk());
  REQUIRE(recorder
              ->event(8, LogLevel::Warning, "pipeline",
                      "frame dropped: the stages are slower than the data")
              .isOk());
  REQUIRE(recorder->event(9, LogLevel::Warning, "map", "another event").isOk());
  REQUIRE(recorder->close().isOk());
  CHECK(RunReader::open(folder.path()).value()->lastGivenFrame().value() == 8);
}
