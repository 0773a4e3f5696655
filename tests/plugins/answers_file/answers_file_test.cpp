// SPDX-License-Identifier: BSD-3-Clause
// The plugins read answers.bin as the host wrote it, bit for bit.
#include "record/answers_file.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "answers_reader.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::test;
using answers_file::AnswersReader;

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

SourceInfo someSource() {
  SourceInfo source;
  source.description = "a street";
  source.rig.width = 640;
  source.rig.pinhole.fx = 1.0 / 3;
  source.frames = 99;
  source.has_truth = true;
  return source;
}

void write(const std::filesystem::path& folder, const std::vector<Answers>& all, bool finish) {
  ArrayInfo depth;
  depth.name = "depth";
  depth.axes.resize(2);
  depth.axes[1].labels = {"near", "far"};
  auto file = record::AnswersFile::create(folder, someSource(), {depth});
  REQUIRE(file.isOk());
  for (const Answers& a : all) REQUIRE(file.value().add(a.frame, a.motion, a.place).isOk());
  if (finish) REQUIRE(file.value().finish(all.back().motion.revisions).isOk());
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

TEST_CASE("all answers come back bit for bit, in order or with gaps") {
  const TemporaryFolder folder;
  const std::vector<Answers> all = randomAnswers(7);
  write(folder.path(), all, true);
  CHECK(record::hasAnswers(folder.path()));
  AnswersReader reader;
  REQUIRE(reader.open(folder.path().string()).isOk());
  CHECK(reader.frames() == 7);
  CHECK(reader.source().frames == 7);
  CHECK(reader.source().description == "a street");
  CHECK(reader.source().rig.pinhole.fx == 1.0 / 3);
  REQUIRE(reader.sensors().size() == 1);
  CHECK(reader.sensors()[0].axes[1].labels[1] == "far");
  for (const std::int64_t i : {0, 1, 2, 5, 6}) {  // 5 has the points of 3
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
  CHECK(revisions.size() == 1);
  Motion beyond;
  Frame after;
  after.frame = 7;
  CHECK(reader.read(after, beyond).code() == StatusCode::InvalidInput);
}

TEST_CASE("answers of a run that was interrupted or failed tell that they are a part") {
  const TemporaryFolder folder;
  write(folder.path(), randomAnswers(7), true);
  const auto opened = [&](const std::string& status) {
    std::ofstream(folder.path() / "run.json") << "{\"status\": \"" + status + "\"}";
    AnswersReader reader;
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
  CHECK(opened("running").empty());
}

TEST_CASE("answers to other frames are refused, even where numbers and times are equal") {
  const TemporaryFolder folder;
  std::vector<Answers> all = randomAnswers(2);
  for (Answers& answers : all) answers.frame.has_truth = true;
  write(folder.path(), all, true);
  AnswersReader reader;
  REQUIRE(reader.open(folder.path().string()).isOk());
  const auto refused = [&](Frame frame) {
    Motion motion;
    PlaceObservation place;
    reader.rewind();
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

TEST_CASE("a file without an end is no replay; reopened at a frame it is the same as before") {
  const TemporaryFolder folder;
  const std::vector<Answers> all = randomAnswers(6);
  write(folder.path(), all, true);
  const auto size = std::filesystem::file_size(folder.path() / "answers.bin");
  write(folder.path(), all, false);
  CHECK_FALSE(record::hasAnswers(folder.path()));
  AnswersReader reader;
  CHECK(reader.open(folder.path().string()).message().find("has not ended") != std::string::npos);

  CHECK(record::AnswersFile::reopen(folder.path(), 9).status().code() == StatusCode::InvalidInput);
  auto file = record::AnswersFile::reopen(folder.path(), 3);  // points of frame 3 come anew
  REQUIRE(file.isOk());
  for (std::size_t i = 3; i < all.size(); ++i) {
    REQUIRE(file.value().add(all[i].frame, all[i].motion, all[i].place).isOk());
  }
  REQUIRE(file.value().finish(all.back().motion.revisions).isOk());
  CHECK(std::filesystem::file_size(folder.path() / "answers.bin") == size);
  REQUIRE(AnswersReader().open(folder.path().string()).isOk());
}

TEST_CASE("answers of another run than the run.json beside them are refused") {
  const TemporaryFolder folder;
  auto file = record::AnswersFile::create(folder.path(), someSource(), {}, "0a1b");
  REQUIRE(file.value().finish({}).isOk());
  const auto opened = [&](const std::string& run_json) {
    std::ofstream(folder.path() / "run.json") << run_json;
    return AnswersReader().open(folder.path().string());
  };
  CHECK(opened(R"({"id": "0a1b"})").isOk());
  CHECK(opened(R"({"name": "a run of an older version"})").isOk());
  CHECK(opened("no JSON").isOk());
  CHECK_THAT(opened(R"({"id": "ffff"})").message(), Catch::Contains("is of another run"));
  CHECK_THAT(opened(R"({"id": 7})").message(), Catch::Contains("is of another run"));

  CHECK(record::AnswersFile::reopen(folder.path(), 0, "0a1b").isOk());
  CHECK_THAT(record::AnswersFile::reopen(folder.path(), 0, "ffff").status().message(),
             Catch::Contains("is of another run"));
}

TEST_CASE("no damaged byte is taken for an answer") {
  const TemporaryFolder folder;
  write(folder.path(), randomAnswers(2), true);
  const auto file = folder.path() / "answers.bin";
  const auto size = std::filesystem::file_size(file);
  for (std::uintmax_t at = 0; at < size; at += 37) {
    const auto broken = folder.path() / "broken";
    std::filesystem::create_directories(broken);
    std::filesystem::copy_file(file, broken / "answers.bin",
                               std::filesystem::copy_options::overwrite_existing);
    std::fstream stream(broken / "answers.bin", std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(at));
    const int byte = stream.get();
    stream.seekp(static_cast<std::streamoff>(at));
    stream.put(static_cast<char>(byte ^ 0x55));
    stream.close();
    AnswersReader reader;
    Status status = reader.open(broken.string());
    for (std::int64_t i = 0; i < 2 && status.isOk(); ++i) {
      Motion motion;
      Frame frame;
      status = reader.read(i, frame);
      if (status.isOk()) status = reader.read(frame, motion);
    }
    std::vector<MotionRevision> revisions;
    if (status.isOk()) status = reader.read(revisions);
    INFO("byte " << at);
    CHECK_FALSE(status.isOk());
  }
}
