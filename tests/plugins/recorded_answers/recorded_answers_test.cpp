// SPDX-License-Identifier: BSD-3-Clause
// The plugins that replay a run read what the host recorded, bit for bit.
#include "recorded_answers.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "record/run_reader.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::test;
using recorded_answers::RecordedAnswers;

namespace {

struct Answers {
  Frame frame;
  Motion motion;
  PlaceObservation place;
};

/// Random answers; every third frame brings points, the next two have the same.
std::vector<Answers> randomAnswers(std::int64_t count) {
  RandomStream random(3);
  std::vector<Answers> all;
  for (std::int64_t i = 0; i < count; ++i) {
    Answers a{randomRecord<Frame>(random), randomRecord<Motion>(random),
              randomRecord<PlaceObservation>(random)};
    a.frame.frame = a.motion.frame = a.place.frame = i;
    a.frame.sensors = {{"depth", {2, 1}, {1.5F, static_cast<float>(i)}}, {"none", {0}, {}}};
    a.motion.revisions = {{i, randomPose(random), Matrix6d::Identity() * 0.1}};
    a.motion.points_frame = i - i % 3;
    if (i % 3 > 0) a.motion.points = all.back().motion.points;
    all.push_back(a);
  }
  return all;
}

void write(const std::filesystem::path& folder, const std::vector<Answers>& all) {
  std::filesystem::remove(folder / "run.sqlite");
  auto recorder = record::Recorder::open(folder).value();
  REQUIRE(recorder->recordForReplay(1).isOk());
  REQUIRE(recorder->session({0, 0, "run", "a street"}).isOk());
  RunInfo run;
  run.source.rig.width = 640;
  run.source.rig.pinhole.fx = 1.0 / 3;
  run.arrays.resize(2);
  run.arrays[0].name = "depth";
  run.arrays[0].axes.resize(2);
  run.arrays[0].axes[1].labels = {"near", "far"};
  run.arrays[1].name = "cells";
  REQUIRE(recorder->begin(run).isOk());
  for (const Answers& a : all) {
    Snapshot snapshot;
    snapshot.frame = &a.frame;
    snapshot.motion = &a.motion;
    snapshot.place = &a.place;
    REQUIRE(recorder->snapshot(snapshot).isOk());
  }
  REQUIRE(recorder->revisions(all.back().motion.revisions).isOk());
  REQUIRE(recorder->close().isOk());
}

void say(const std::filesystem::path& folder, const std::string& status) {
  std::ofstream(folder / "run.json")
      << R"({"status": ")" + status + R"(", "source": {"frames": 99, "has_truth": true}})";
}

void checkSame(const Motion& read, const Motion& written) {
  CHECK(read.T_previous_current.matrix() == written.T_previous_current.matrix());
  CHECK(read.covariance == written.covariance);
  CHECK(read.points == written.points);
  CHECK(read.state == written.state);
  CHECK(read.v == written.v);
  REQUIRE(read.revisions.size() == 1);
  CHECK(read.revisions[0].T_previous_current.matrix() ==
        written.revisions[0].T_previous_current.matrix());
}

}  // namespace

TEST_CASE("all answers come back bit for bit, in any order") {
  const TemporaryFolder folder;
  const std::vector<Answers> all = randomAnswers(7);
  write(folder.path(), all);
  say(folder.path(), "finished");
  CHECK(record::canBeReplayed(folder.path()));
  RecordedAnswers reader;
  REQUIRE(reader.open(folder.path().string()).isOk());
  CHECK(reader.frames() == 7);
  CHECK(reader.source().frames == 7);
  CHECK(reader.source().has_truth);
  CHECK(reader.source().description == "a street");
  CHECK(reader.source().rig.pinhole.fx == 1.0 / 3);
  REQUIRE(reader.sensors().size() == 1);
  CHECK(reader.sensors()[0].axes[1].labels[1] == "far");
  for (const std::int64_t i : {0, 1, 2, 5, 6, 4}) {  // 5 has the points of 3
    const Answers& a = all[static_cast<std::size_t>(i)];
    Frame frame;
    Motion motion;
    PlaceObservation place;
    REQUIRE(reader.read(i, frame).isOk());
    REQUIRE(reader.read(frame, motion).isOk());
    REQUIRE(reader.read(frame, place).isOk());
    CHECK(frame.T_world_camera_truth.matrix() == a.frame.T_world_camera_truth.matrix());
    CHECK(frame.stamp_ns == a.frame.stamp_ns);
    CHECK(frame.defect == a.frame.defect);
    REQUIRE(frame.sensors.size() == 2);
    CHECK(frame.sensors[0].values == a.frame.sensors[0].values);
    checkSame(motion, a.motion);
    CHECK(place.T_template_current.matrix() == a.place.T_template_current.matrix());
    CHECK(place.score == a.place.score);
  }
  std::vector<MotionRevision> revisions;
  REQUIRE(reader.read(revisions).isOk());
  REQUIRE(revisions.size() == 1);
  CHECK(revisions[0].T_previous_current.matrix() ==
        all.back().motion.revisions[0].T_previous_current.matrix());
  Motion beyond;
  Frame after;
  after.frame = 7;
  CHECK(reader.read(after, beyond).code() == StatusCode::InvalidInput);
}

TEST_CASE("answers of a run that was interrupted or failed say that they are a part") {
  const TemporaryFolder folder;
  write(folder.path(), randomAnswers(7));
  const auto opened = [&](const std::string& status) {
    say(folder.path(), status);
    RecordedAnswers reader;
    REQUIRE(reader.open(folder.path().string()).isOk());
    Frame beyond;
    CHECK(reader.read(7, beyond).message().ends_with(
        reader.part().empty() ? "in a run that continues no map" : reader.part()));
    return reader.part();
  };
  CHECK_THAT(
      opened("interrupted"),
      Catch::StartsWith("has 7 of the 99 frames of its source, because its run was interrupted; "));
  CHECK_THAT(opened("failed"), Catch::Contains("because its run failed; "));
  CHECK(opened("finished").empty());
}

TEST_CASE("answers to other frames are refused, even where numbers and times are equal") {
  const TemporaryFolder folder;
  std::vector<Answers> all = randomAnswers(2);
  for (Answers& answers : all) answers.frame.has_truth = true;
  write(folder.path(), all);
  RecordedAnswers reader;
  REQUIRE(reader.open(folder.path().string()).isOk());
  const auto refused = [&](const Frame& frame) {
    Motion motion;
    PlaceObservation place;
    const Status status = reader.read(frame, motion);
    CHECK(reader.read(frame, place).message() == status.message());
    return status.message().find("take source, odometry and place of one record") !=
           std::string::npos;
  };
  Frame frame = all[1].frame;
  CHECK_FALSE(refused(frame));
  Frame elsewhere = frame;
  elsewhere.T_world_camera_truth.translation().x() += 1e-9;
  CHECK(refused(elsewhere));
  elsewhere.has_truth = false;  // a source without truth may be the same drive
  CHECK_FALSE(refused(elsewhere));
  ++frame.stamp_ns;
  CHECK(refused(frame));
  frame = all[1].frame;
  ++frame.source_index;
  CHECK(refused(frame));
}

TEST_CASE("what cannot be replayed says why") {
  const TemporaryFolder folder;
  const auto problem = [&] { return RecordedAnswers().open(folder.path().string()).message(); };
  CHECK_THAT(problem(), Catch::Contains("run.sqlite: is not there"));
  REQUIRE(record::Recorder::open(folder.path()).isOk());
  CHECK_THAT(problem(), Catch::Contains("record the run with `record.replay: true`"));
  say(folder.path(), "running");
  CHECK_THAT(problem(), Catch::Contains("the run has not ended: `tolman run --resume`"));
  CHECK_FALSE(record::canBeReplayed(folder.path()));
  std::vector<Answers> all = randomAnswers(3);
  all.erase(all.begin() + 1);
  write(folder.path(), all);
  say(folder.path(), "finished");
  CHECK_THAT(problem(), Catch::Contains("dropped frames or continued a map has no replay"));
}
