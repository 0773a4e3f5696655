// SPDX-License-Identifier: BSD-3-Clause
// A replay gives the recorded data, of a running and of a finished run.
#include <catch2/catch.hpp>

#include "record/run_reader.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

/// All that a replay of what is there now gives, from `position` on.
std::vector<RecordedFrame> replayed(const std::filesystem::path& folder, ReplayPosition& position,
                                    bool unfinished = false) {
  const auto reader = RunReader::open(folder).value();
  const auto replay = std::move(Replay::open(*reader, position, unfinished)).value();
  std::vector<RecordedFrame> frames;
  RecordedFrame frame;
  while (replay->next(frame).value()) frames.push_back(frame);
  position = replay->position();
  return frames;
}

std::vector<RecordedFrame> replayed(const std::filesystem::path& folder) {
  ReplayPosition position;
  return replayed(folder, position);
}

}  // namespace

TEST_CASE("frames come back in order with their records, arrays, times and events") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  REQUIRE(recorder->event(-1, LogLevel::Info, "source", "before the first").isOk());
  for (std::int64_t i = 0; i < 5; ++i) {
    REQUIRE(test::recordFrame(*recorder, i).isOk());
    REQUIRE(recorder->timing(i, "odometry", 1000 + i).isOk());
    REQUIRE(recorder->timing(i, "map", 2000 + i).isOk());
    REQUIRE(recorder->timing(i, "coffee", 1).isOk());  // no stage that is known here
    if (i >= 3) REQUIRE(recorder->event(i, LogLevel::Warning, "odometry", "lost").isOk());
  }
  REQUIRE(recorder->event(-1, LogLevel::Warning, "teardown", "after the last").isOk());
  REQUIRE(recorder->close().isOk());
  const auto frames = replayed(folder.path());
  REQUIRE(frames.size() == 5);
  for (std::int64_t i = 0; i < 5; ++i) {
    const RecordedFrame& frame = frames[static_cast<std::size_t>(i)];
    CHECK(frame.frame.frame == i);
    CHECK(frame.frame.stamp_ns == test::frameAt(i).stamp_ns);
    REQUIRE(frame.motion);
    CHECK(frame.motion->v == Approx(test::motionAt(i).v));
    REQUIRE(frame.map);
    CHECK(frame.map->T_experience_camera.translation().z() == static_cast<double>(i));
    CHECK_FALSE(frame.place);
    CHECK_FALSE(frame.decision);
    REQUIRE(frame.cells.size() == 1);
    CHECK(frame.cells[0].values == std::vector<float>{1, 2, static_cast<float>(i)});
    CHECK(frame.stage_times_ns == StageTimes{0, 1000 + i, 0, 0, 2000 + i, 0});
  }
  REQUIRE(frames[0].events.size() == 1);
  CHECK(frames[0].events[0].message == "before the first");
  CHECK(frames[1].events.empty());
  REQUIRE(frames[3].events.size() == 1);
  CHECK(frames[3].events[0].level == LogLevel::Warning);
  REQUIRE(frames[4].events.size() == 2);
  CHECK(frames[4].events[1].message == "after the last");
  const Snapshot snapshot = frames[3].snapshot();
  CHECK(snapshot.frame == &frames[3].frame);
  CHECK(snapshot.motion == &*frames[3].motion);
  CHECK(snapshot.place == nullptr);
  CHECK(snapshot.graph == nullptr);
}

TEST_CASE("points that were stored once are there at every frame") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  for (std::int64_t i = 0; i < 4; ++i) {
    const Frame frame = test::frameAt(i);
    Motion motion = test::motionAt(i);
    motion.points_frame = i < 3 ? 0 : 3;
    motion.points.setConstant(4, 2 + motion.points_frame, 0.5F);
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    REQUIRE(recorder->snapshot(snapshot).isOk());
    REQUIRE(recorder->commit().isOk());
  }
  const auto all = replayed(folder.path());
  REQUIRE(all.size() == 4);
  CHECK(all[2].motion->points.cols() == 2);
  CHECK(all[3].motion->points.cols() == 5);
  ReplayPosition position;  // also when the replay goes on later
  CHECK(replayed(folder.path(), position, true).size() == 3);
  CHECK(position.points.cols() == 2);
}

TEST_CASE("a replay of a run that goes on leaves the newest frame, and goes on from there") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  ReplayPosition position;
  CHECK(replayed(folder.path(), position, true).empty());
  std::int64_t seen = 0;
  for (std::int64_t i = 0; i < 6; ++i) {
    REQUIRE(test::recordFrame(*recorder, i).isOk());
    REQUIRE(recorder->timing(i, "cells", 100 + i).isOk());
    REQUIRE(recorder->event(i, LogLevel::Info, "map", std::to_string(i)).isOk());
    REQUIRE(recorder->commit().isOk());
    if (i % 2 == 0) continue;
    for (const RecordedFrame& frame : replayed(folder.path(), position, true)) {
      CHECK(frame.frame.frame == seen);
      CHECK(frame.stage_times_ns[3] == 100 + seen);
      REQUIRE(frame.events.size() == 1);
      CHECK(frame.events[0].message == std::to_string(seen));
      ++seen;
    }
    CHECK(seen == i);
  }
  REQUIRE(recorder->close().isOk());
  const auto rest = replayed(folder.path(), position);
  REQUIRE(rest.size() == 1);
  CHECK(rest[0].frame.frame == 5);
  CHECK(replayed(folder.path(), position).empty());
}

TEST_CASE("frames that were dropped are no frames of the replay") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  for (const std::int64_t i : {0, 3, 4, 9}) REQUIRE(test::recordFrame(*recorder, i).isOk());
  REQUIRE(recorder->close().isOk());
  std::vector<std::int64_t> indices;
  for (const auto& frame : replayed(folder.path())) indices.push_back(frame.frame.frame);
  CHECK(indices == std::vector<std::int64_t>{0, 3, 4, 9});
  ReplayPosition position;  // the newest may be incomplete
  CHECK(replayed(folder.path(), position, true).size() == 3);
  CHECK(position.frame == 4);
}

TEST_CASE("a damaged row is a failure that names the file") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  for (std::int64_t i = 0; i < 3; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  REQUIRE(recorder->close().isOk());
  openDatabase(folder.path() / "run.sqlite", Access::Create)
      .exec("UPDATE \"motion\" SET \"state\" = 'asleep' WHERE \"frame\" = 2");
  const auto reader = RunReader::open(folder.path()).value();
  const auto replay = std::move(Replay::open(*reader, {}, false)).value();
  RecordedFrame frame;
  CHECK(replay->next(frame).isOk());
  CHECK(replay->next(frame).isOk());
  const auto third = replay->next(frame);
  REQUIRE_FALSE(third.isOk());
  CHECK(third.status().code() == StatusCode::InvalidInput);
  CHECK(third.status().message().find("run.sqlite: 'asleep'") != std::string::npos);
}
