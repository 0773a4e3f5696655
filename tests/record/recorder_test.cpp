// SPDX-License-Identifier: BSD-3-Clause
#include "record/recorder.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <utility>

#include "record/run_reader.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

TEST_CASE("a whole snapshot is stored and read back, lists included") {
  const test::TemporaryFolder folder;
  RandomStream random(31);
  const Frame first = test::frameAt(0);
  Frame frame = test::frameAt(1);
  frame.sensors = {{"gyroscope.yaw_rate", {1}, {0.5F}}, {"sonar", {2, 2}, {1, 2, 3, 4}}};
  const Motion first_motion = test::motionAt(0);
  Motion motion = test::motionAt(1);
  motion.revisions = {{0, test::randomPose(random), Matrix6d::Identity()},
                      {1, test::randomPose(random), Matrix6d::Identity()}};
  auto recorder = Recorder::open(folder.path()).value();
  Snapshot snapshot;
  snapshot.frame = &first;
  snapshot.motion = &first_motion;
  REQUIRE(recorder->snapshot(snapshot).isOk());
  snapshot.frame = &frame;
  snapshot.motion = &motion;
  const std::vector<NamedArray> cells = {{"hd", {3}, {1, 2, 3}}};
  snapshot.cells = &cells;
  REQUIRE(recorder->snapshot(snapshot).isOk());
  REQUIRE(recorder->commit().isOk());  // and the run goes on

  const auto reader = RunReader::open(folder.path()).value();
  const auto frames = reader->records<Frame>().value();
  REQUIRE(frames.size() == 2);
  REQUIRE(frames[1].sensors.size() == 2);
  CHECK(frames[1].sensors[1].name == "sonar");
  CHECK(frames[1].sensors[1].shape == std::vector<int>{2, 2});
  CHECK(frames[1].sensors[1].values == std::vector<float>{1, 2, 3, 4});
  const auto motions = reader->records<Motion>().value();
  REQUIRE(motions.size() == 2);
  REQUIRE(motions[1].revisions.size() == 2);
  CHECK(motions[1].revisions[1].frame == 1);
  std::vector<NamedArray> read;
  REQUIRE(reader->visitCellArrays([&](std::int64_t, NamedArray a) { read.push_back(a); }).isOk());
  CHECK(read.at(0).values == std::vector<float>{1, 2, 3});
}

TEST_CASE("points are stored once for each frame that they belong to") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  for (std::int64_t i = 0; i < 4; ++i) {
    const Frame frame = test::frameAt(i);
    Motion motion = test::motionAt(i);
    motion.points_frame = i < 3 ? 0 : 3;
    motion.points = Eigen::Matrix<float, 4, Eigen::Dynamic>::Constant(4, 6, 1.5F);
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    REQUIRE(recorder->snapshot(snapshot).isOk());
  }
  REQUIRE(recorder->close().isOk());
  const auto motions = RunReader::open(folder.path()).value()->records<Motion>().value();
  CHECK(motions[0].points.cols() == 6);
  CHECK(motions[1].points.cols() == 0);
  CHECK(motions[2].points.cols() == 0);
  CHECK(motions[3].points.cols() == 6);
  CHECK(motions[3].points(3, 5) == 1.5F);
}

TEST_CASE("a corrected map replaces what was known, and only that") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  for (std::int64_t i = 0; i < 3; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  MapGraph graph{1,
                 {test::experienceAt(0, 0, 0), test::experienceAt(1, 2, 2)},
                 {test::linkBetween(0, 0, 1, 2)},
                 {}};
  REQUIRE(recorder->graph(graph).isOk());
  graph.experiences[1].T_world_experience.translation().z() = 2.5;
  graph.links[0].weight = 0.25;
  REQUIRE(recorder->graph(graph).isOk());
  REQUIRE(recorder->close().isOk());
  const MapGraph read = RunReader::open(folder.path()).value()->graph().value();
  REQUIRE(read.experiences.size() == 2);
  CHECK(read.experiences[1].T_world_experience.translation().z() == 2.5);
  REQUIRE(read.links.size() == 1);
  CHECK(read.links[0].weight == 0.25);
}

TEST_CASE("links that the map removes leave the table") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  for (std::int64_t i = 0; i < 3; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  MapGraph graph{1,
                 {test::experienceAt(0, 0, 0), test::experienceAt(1, 2, 2)},
                 {test::linkBetween(0, 0, 1, 1), test::linkBetween(1, 1, 0, 2)},
                 {}};
  REQUIRE(recorder->graph(graph).isOk());
  graph.links.erase(graph.links.begin());
  graph.links[0].id = 0;
  REQUIRE(recorder->graph(graph).isOk());
  REQUIRE(recorder->close().isOk());
  const MapGraph read = RunReader::open(folder.path()).value()->graph().value();
  REQUIRE(read.links.size() == 1);
  CHECK(read.links[0].from == 1);
  CHECK(read.links[0].frame == 2);
}

TEST_CASE("a row that breaks a rule ends the record at the last commit") {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "run.sqlite").string();
  {
    auto recorder = Recorder::open(folder.path()).value();
    REQUIRE(test::recordFrame(*recorder, 0).isOk());
    REQUIRE(recorder->commit().isOk());
    CHECK(test::recordFrame(*recorder, 0).message() ==
          file + ": UNIQUE constraint failed: frame.frame");
    CHECK_FALSE(test::recordFrame(*recorder, 1).isOk());
    CHECK_FALSE(recorder->close().isOk());
  }
  CHECK(RunReader::open(folder.path()).value()->totals().value().frames == 1);
  auto recorder = Recorder::reopen(folder.path(), 1).value();
  CHECK_FALSE(recorder->snapshot(Snapshot{}).isOk());
  const MapGraph orphan{1, {test::experienceAt(0, 0, 0)}, {test::linkBetween(0, 0, 7, 0)}, {}};
  CHECK(recorder->graph(orphan).message() == file + ": FOREIGN KEY constraint failed");
}

TEST_CASE("timing, events and meta values are stored; a closed recorder refuses") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  REQUIRE(recorder->timing(0, "odometry", 5).isOk());
  REQUIRE(recorder->timing(1, "odometry", 7).isOk());
  REQUIRE(recorder->event(-1, LogLevel::Warning, "host", "careful").isOk());
  REQUIRE(recorder->meta("name", "one").isOk());
  REQUIRE(recorder->meta("name", "two").isOk());
  REQUIRE(recorder->close().isOk());
  CHECK(recorder->close().isOk());
  CHECK_FALSE(recorder->meta("name", "three").isOk());
  const auto reader = RunReader::open(folder.path()).value();
  CHECK(reader->timing().value().at("odometry") == std::vector<std::int64_t>{5, 7});
  CHECK(reader->meta().value().at("name") == "two");
  CHECK(reader->meta().value().at("schema_version") == "6");
  // A closed run is one plain file.
  CHECK_FALSE(std::filesystem::exists(folder.path() / "run.sqlite-wal"));
}

TEST_CASE("the file alone is whole after a run that ended while others read it") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  REQUIRE(test::recordFrame(*recorder, 0).isOk());
  REQUIRE(recorder->commit().isOk());
  const SQLite::Database idle((folder.path() / "run.sqlite").string());  // as in a notebook
  idle.tableExists("frame");
  std::jthread reading([&] {
    const auto reader = RunReader::open(folder.path()).value();  // in a transaction
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  REQUIRE(test::recordFrame(*recorder, 1).isOk());
  REQUIRE(recorder->close().isOk());
  const test::TemporaryFolder copy;
  std::filesystem::copy_file(folder.path() / "run.sqlite", copy.path() / "run.sqlite");
  CHECK(RunReader::open(copy.path()).value()->totals().value().frames == 2);
}

TEST_CASE("several threads write at once") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&recorder, t] {
        for (int i = 0; i < 200; ++i) {
          (void)recorder->timing(i, "stage" + std::to_string(t), i);
        }
      });
    }
  }
  REQUIRE(recorder->close().isOk());
  const auto timing = RunReader::open(folder.path()).value()->timing().value();
  REQUIRE(timing.size() == 4);
  for (const auto& [stage, durations] : timing) CHECK(durations.size() == 200);
}

TEST_CASE("an existing record, or a missing folder, is refused") {
  const test::TemporaryFolder folder;
  REQUIRE(Recorder::open(folder.path()).isOk());
  CHECK(Recorder::open(folder.path()).status().message() ==
        (folder.path() / "run.sqlite").string() + ": exists; record into a fresh directory");
  CHECK_FALSE(Recorder::open(folder.path() / "absent").isOk());
}

TEST_CASE("a full disk is a failure, and all later calls return it") {
  const test::TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    // No file may grow beyond 1 MB: writes then fail as on a full disk.
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1 << 20, 1 << 20};
    setrlimit(RLIMIT_FSIZE, &limit);
    auto recorder = Recorder::open(folder.path());
    if (!recorder.isOk()) _exit(2);
    Status status;
    for (std::int64_t i = 0; i < 100'000 && status.isOk(); ++i) {
      status = test::recordFrame(*recorder.value(), i);
      if (status.isOk() && i % 100 == 0) status = recorder.value()->commit();
    }
    if (status.isOk()) _exit(3);
    if (recorder.value()->close().message() != status.message()) _exit(4);
    if (recorder.value()->meta("a", "b").isOk()) _exit(5);
    _exit(status.message().find("look for a full disk") != std::string::npos ? 0 : 6);
  }
  int result = 0;
  REQUIRE(waitpid(child, &result, 0) == child);
  REQUIRE(WIFEXITED(result));
  CHECK(WEXITSTATUS(result) == 0);
  // What was committed before is still there.
  const auto reader = RunReader::open(folder.path());
  REQUIRE(reader.isOk());
  CHECK(reader.value()->totals().value().frames > 100);
}

TEST_CASE("the automatic step keeps at most 5,000 frames, as if the length had been known") {
  CHECK(arrayStep(0) == 1);
  CHECK(arrayStep(kMostArrayFrames - 1) == 1);
  CHECK(arrayStep(kMostArrayFrames) == 2);
  CHECK(arrayStep(4 * kMostArrayFrames - 1) == 4);
  CHECK(arrayStep(499'509) == 128);
  const test::TemporaryFolder folder;
  const auto recorded = [&] {
    const auto reader = RunReader::open(folder.path()).value();
    std::vector<std::int64_t> frames;
    REQUIRE(reader
                ->visitCellArrays(
                    [&](std::int64_t frame, const NamedArray&) { frames.push_back(frame); })
                .isOk());
    return frames;
  };
  const std::int64_t end = kMostArrayFrames * 2 + 1000;
  bool was_interrupted = false;
  auto recorder = Recorder::open(folder.path()).value();
  recorder->recordArrays(kAutomatic);
  for (std::int64_t i = 0; i < end; ++i) {
    REQUIRE(test::recordFrame(*recorder, i).isOk());
    if (i != kMostArrayFrames + 500 || std::exchange(was_interrupted, true)) continue;
    REQUIRE(recorder->commit().isOk());
    CHECK(std::ssize(recorded()) == kMostArrayFrames);  // 251 were added, and as many removed
    REQUIRE(recorder->sync().isOk());
    REQUIRE(recorder->close().isOk());  // as a run that is interrupted, and resumed a bit earlier
    CHECK(std::ssize(recorded()) == (i + 2) / 2);
    i -= 100;
    recorder = Recorder::reopen(folder.path(), i + 1).value();
    recorder->recordArrays(kAutomatic);
  }
  REQUIRE(recorder->close().isOk());
  const auto frames = recorded();
  CHECK(frames.size() == static_cast<std::size_t>(end / 4));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i] != static_cast<std::int64_t>(4 * i)) FAIL("frame " << frames[i]);
  }
}

TEST_CASE("arrays are recorded every N frames, or never") {
  for (const int every : {0, 1, 3}) {
    const test::TemporaryFolder folder;
    auto recorder = Recorder::open(folder.path()).value();
    recorder->recordArrays(every);
    for (std::int64_t i = 0; i < 7; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
    REQUIRE(recorder->close().isOk());
    std::string frames;
    REQUIRE(RunReader::open(folder.path())
                .value()
                ->visitCellArrays(
                    [&](std::int64_t frame, const NamedArray&) { frames += std::to_string(frame); })
                .isOk());
    CHECK(frames == (every == 0 ? "" : every == 1 ? "0123456" : "036"));
  }
}
