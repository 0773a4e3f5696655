// SPDX-License-Identifier: BSD-3-Clause
// Motion without images: frames with sensors and truth from files; invalid files are refused.
#include "motion_log.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "support/context.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::motion_log;
using tolman::test::TemporaryFolder;
using tolman::test::TestContext;

namespace {

/// A square: four sides of 2 m, a quarter turn left after each; frame 4 is frame 0 again.
struct Square {
  Square() {
    write("odometry.g2o",
          "# a comment\nVERTEX_SE2 0 0 0 0\n"
          "EDGE_SE2 0 1 2 0 1.5707963 1 0 0 1 0 1\nEDGE_SE2 1 2 2 0 1.5707963 1 0 0 1 0 1\n"
          "EDGE_SE2 2 3 2 0 1.5707963 1 0 0 1 0 1\nEDGE_SE2 3 4 2 0 1.5707963 1 0 0 1 0 1\n");
    write("ground_truth.g2o",
          "EDGE_SE2 0 1 2.1 0 1.5707963 1 0 0 1 0 1\nEDGE_SE2 1 2 2.1 0 1.5707963 1 0 0 1 0 1\n"
          "EDGE_SE2 2 3 2.1 0 1.5707963 1 0 0 1 0 1\nEDGE_SE2 3 4 2.1 0 1.5707963 1 0 0 1 0 1\n");
    write("loop_candidates.g2o",
          "EDGE_SE2 4 0 0.5 0.25 0.1 1 0 0 1 0 1\nEDGE_SE2 4 1 0 0 0 1 0 0 1 0 1\n");
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder.path() / name) << text;
  }
  ParameterValues values(ParameterValues more = {}) const {
    more["path"] = folder.path().string();
    return more;
  }
  TemporaryFolder folder;
};

std::vector<Frame> drive(const ParameterValues& values) {
  TestContext context(values);
  MotionLog source;
  const Status status = source.configure(context);
  INFO(status.message());
  REQUIRE(status.isOk());
  std::vector<Frame> frames;
  for (Frame frame; source.next(frame).isOk(); frame = {}) frames.push_back(frame);
  return frames;
}

const std::vector<float>& motionOf(const Frame& frame) {
  REQUIRE(frame.sensors.size() == 4);
  REQUIRE(frame.sensors[0].name == "motion.planar");
  return frame.sensors[0].values;
}

std::string refusal(const Square& square) {
  TestContext context(square.values());
  MotionLog source;
  const Status status = source.configure(context);
  REQUIRE_FALSE(status.isOk());
  std::string message(status.message());
  const std::string folder = square.folder.path().string() + "/";
  if (message.starts_with(folder)) message.erase(0, folder.size());
  return message;
}

}  // namespace

TEST_CASE("frames carry motion, candidates and truth") {
  const Square square;
  const std::vector<Frame> frames = drive(square.values());
  REQUIRE(frames.size() == 5);
  CHECK(motionOf(frames[0]) == std::vector<float>{0, 0, 0});
  for (std::size_t k = 1; k < 5; ++k) {
    CHECK(motionOf(frames[k])[0] == Approx(2));
    CHECK(motionOf(frames[k])[1] == Approx(0).margin(1e-6));
    CHECK(motionOf(frames[k])[2] == Approx(1.5707963));
    CHECK(frames[k].stamp_ns == static_cast<std::int64_t>(k) * 100'000'000);
    CHECK(frames[k].left.empty());
  }
  const PlanarPose truth = toPlanar(frames[2].T_world_camera_truth);
  CHECK(truth.x == Approx(2.1));
  CHECK(truth.y == Approx(2.1));
  CHECK(std::abs(truth.theta) == Approx(3.1415926).margin(1e-5));
  const NamedArray& alike = frames[4].sensors[1];
  CHECK(alike.shape == std::vector<int>{2, 4});
  CHECK(alike.values == std::vector<float>{0, 0.5F, 0.25F, 0.1F, 1, 0, 0, 0});
  CHECK(frames[3].sensors[1].values.empty());
  std::vector<float> looked;  // where candidates begin or end
  for (const Frame& frame : frames) looked.push_back(frame.sensors[2].values.at(0));
  CHECK(looked == std::vector<float>{1, 1, 0, 0, 1});
}

TEST_CASE("frames say which drive they are of: the odometry's, whatever else is read") {
  const Square square;
  const auto drive_of = [](const Frame& frame) {
    REQUIRE(frame.sensors.at(3).name == "motion.drive");
    return frame.sensors[3].values.at(0);
  };
  const float whole = drive_of(drive(square.values()).at(0));
  CHECK(drive_of(drive(square.values({{"first", 2}, {"candidates", ""}})).at(1)) == whole);
  CHECK(whole == std::trunc(whole));
  square.write("odometry.g2o",
               "EDGE_SE2 0 1 2 0 1.5707963 1 0 0 1 0 1\nEDGE_SE2 1 2 2 0 1.5707964 1 0 0 1 0 1\n");
  square.write("ground_truth.g2o",
               "EDGE_SE2 0 1 2 0 1.57 1 0 0 1 0 1\nEDGE_SE2 1 2 2 0 1.57 1 0 0 1 0 1\n");
  square.write("loop_candidates.g2o", "");
  CHECK(drive_of(drive(square.values()).at(0)) != whole);
}

TEST_CASE("steps compose the motion, the way back inverts it") {
  const Square square;
  const std::vector<Frame> coarse = drive(square.values({{"step", std::int64_t{2}}}));
  REQUIRE(coarse.size() == 3);
  CHECK(motionOf(coarse[1])[0] == Approx(2));
  CHECK(motionOf(coarse[1])[1] == Approx(2));
  const std::vector<Frame> back = drive(square.values({{"order", std::string("backward")}}));
  // From (0, 0) facing +x again to where that last side began: 2 m, straight back and turned.
  const PlanarPose step = {motionOf(back[1])[0], motionOf(back[1])[1], motionOf(back[1])[2]};
  const PlanarPose round = compose(step, {2, 0, 1.5707963});
  CHECK(round.x == Approx(0).margin(1e-6));
  CHECK(round.y == Approx(0).margin(1e-6));
  CHECK(round.theta == Approx(0).margin(1e-6));
}

TEST_CASE("what is wrong with a file is said with line and remedy") {
  const Square square;
  SECTION("missing") {
    std::filesystem::remove(square.folder.path() / "odometry.g2o");
    CHECK(refusal(square) == "odometry.g2o: is missing; restore it, or correct the path");
  }
  SECTION("gap") {
    square.write("odometry.g2o",
                 "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 2 3 1 0 0 1 0 0 1 0 1\n");
    CHECK(refusal(square) ==
          "odometry.g2o: no edge leads from 1 to 2, and there are no vertices of the two; add one");
  }
  SECTION("not a number") {
    square.write("odometry.g2o", "EDGE_SE2 0 1 1 zero 0 1 0 0 1 0 1\n");
    CHECK(refusal(square) ==
          "odometry.g2o:1: needs two ids from 0 and three numbers (dx dy dtheta) of at most 1e9; "
          "correct it");
  }
  SECTION("infinite") {
    square.write("odometry.g2o", "EDGE_SE2 0 1 1e999 0 0 1 0 0 1 0 1\n");
    CHECK(refusal(square).starts_with("odometry.g2o:1: needs two ids"));
  }
  SECTION("truth of another sequence") {
    square.write("ground_truth.g2o", "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n");
    CHECK(refusal(square) ==
          "ground_truth.g2o has 2 poses, the odometry 5; give the truth of this sequence");
  }
  SECTION("truth that is a link to nothing") {
    std::filesystem::remove(square.folder.path() / "ground_truth.g2o");
    CHECK(drive(square.values()).size() == 5);  // no truth
    std::filesystem::create_symlink("nowhere", square.folder.path() / "ground_truth.g2o");
    CHECK(refusal(square) == "ground_truth.g2o: is missing; restore it, or correct the path");
  }
  SECTION("truth that was named and is not there") {
    TestContext context(square.values({{"truth", std::string("mine.g2o")}}));
    MotionLog source;
    CHECK_THAT(source.configure(context).message(),
               Catch::EndsWith("mine.g2o: is missing; restore it, or correct the path"));
  }
  SECTION("cut within a number") {
    square.write("odometry.g2o", "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 1 2 1 0.00");
    CHECK(refusal(square).starts_with("odometry.g2o:2: needs two ids"));
    square.write("odometry.g2o", "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 1 2 1 0.001 0.0");
    CHECK(refusal(square) ==
          "odometry.g2o:2: has 0 information values instead of six after dx dy dtheta; the file "
          "may be cut off");
  }
  SECTION("a candidate beyond the end") {
    square.write("loop_candidates.g2o", "EDGE_SE2 9 3 0 0 0 1 0 0 1 0 1\n");
    CHECK(refusal(square) ==
          "loop_candidates.g2o:1: there is no frame 9; the odometry has 5, and the candidates must "
          "be of the same drive");
  }
}

TEST_CASE("one file with motion and loops is a drive with candidates to earlier frames") {
  const Square square;
  square.write("square.g2o",
               "VERTEX_SE2 0 0 0 0\nEDGE_SE2 1 4 0 0 1.5 1 0 0 1 0 1\n"
               "EDGE_SE2 2 3 2 0 1.5707963 1 0 0 1 0 1\nEDGE_SE2 0 1 2 0 1.5707963 1 0 0 1 0 1\n"
               "EDGE_SE2 3 4 2 0 1.5707963 1 0 0 1 0 1\nEDGE_SE2 1 2 2 0 1.5707963 1 0 0 1 0 1\n"
               "EDGE_SE2 4 1 0.5 0 0 1 0 0 1 0 1\nEDGE_SE2 4 0 0.5 0 0 1 0 0 1 0 1\n");
  TestContext context({{"path", (square.folder.path() / "square.g2o").string()}, {"rate", 1.0}});
  MotionLog source;
  REQUIRE(source.configure(context).isOk());
  REQUIRE(context.findings.size() == 1);
  CHECK(context.findings[0].message == "repeats 1 candidates; the first of each is used");
  SourceInfo info;
  REQUIRE(source.info(info).isOk());
  CHECK_FALSE(info.has_truth);  // that of the folder is of another drive
  Frame frame;
  for (int i = 0; i < 5; ++i) REQUIRE(source.next(frame = {}).isOk());
  const NamedArray& alike = frame.sensors.at(1);
  REQUIRE(alike.shape == std::vector<int>{2, 4});
  CHECK(alike.values[0] == 1);  // backwards, so inverted
  CHECK(alike.values[3] == -1.5F);
  CHECK(alike.values[4] == 0);
  CHECK(alike.values[5] == 0.5F);
}

TEST_CASE("garbage never crashes the reader") {
  const Square square;
  RandomStream random(3);
  for (int i = 0; i < 300; ++i) {
    std::string text = "EDGE_SE2 0 1 2 0 1.57 1 0 0 1 0 1\nEDGE_SE2 1 2 2 0 1.57 1 0 0 1 0 1\n";
    for (int k = 0; k < 3; ++k) {
      text[random.below(text.size())] = static_cast<char>(random.below(256));
    }
    square.write("odometry.g2o", text);
    TestContext context(square.values());
    MotionLog source;
    (void)source.configure(context);
  }
}

TEST_CASE("the real sequences are read whole", "[data]") {
  const auto folder = tolman::test::dataOrSkip("kitti_motion/00");
  if (!folder) return;
  const std::vector<Frame> frames = drive({{"path", folder->string()}});
  CHECK(frames.size() == 4541);
  std::size_t candidates = 0;
  for (const Frame& frame : frames) candidates += frame.sensors[1].values.size() / 4;
  CHECK(candidates == 433);
}
