// SPDX-License-Identifier: BSD-3-Clause
// The source kitti on a valid generated sequence.
#include "kitti_source.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "data_folder.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::image_folders {
namespace {

ParameterValues with(const DataFolder& data, ParameterValues more = {}) {
  more["path"] = data.path().string();
  return more;
}

/// A configured source and all of its frames.
struct Run {
  explicit Run(ParameterValues values) {
    const std::string problem = configure(source, std::move(values));
    INFO(problem);
    REQUIRE(problem.empty());
    REQUIRE(source.info(info).isOk());
    frames = readAll(source, failure);
  }
  KittiSource source;
  SourceInfo info;
  std::string failure;
  std::vector<Frame> frames;
};

}  // namespace

TEST_CASE("a sound sequence") {
  const DataFolder data;
  const Run run(with(data));
  CHECK(run.info.description ==
        "KITTI odometry, 4 stereo pairs of 64x48 px at 10.0 Hz, baseline 0.5000 m, with truth");
  CHECK(run.info.frames == 4);
  CHECK(run.info.has_truth);
  CHECK(run.info.rig.width == 64);
  CHECK(run.info.rig.height == 48);
  CHECK(run.info.rig.calibrated);
  CHECK(run.info.rig.pinhole.cx == 31.5);
  CHECK(run.info.rig.baseline == 0.5);
  REQUIRE(run.frames.size() == 4);
  for (int i = 0; i < 4; ++i) {
    const Frame& frame = run.frames[static_cast<std::size_t>(i)];
    CHECK(frame.frame == i);
    CHECK(frame.source_index == i);
    CHECK(frame.stamp_ns == i * 100'000'000LL);
    CHECK(frame.T_world_camera_truth.translation().z() == Approx(i));  // frame 0 is the world
    const std::string name = "/00000" + std::to_string(i) + ".png";
    const int grey = cv::IMREAD_GRAYSCALE;
    CHECK(cv::norm(asMat(frame.left), cv::imread(data.path("image_0" + name).string(), grey)) == 0);
    CHECK(cv::norm(asMat(frame.right), cv::imread(data.path("image_1" + name).string(), grey)) ==
          0);
    CHECK(firstInvalidField(frame).empty());
  }
}

TEST_CASE("reset starts again, and the end stays the end") {
  const DataFolder data;
  Run run(with(data));
  Frame frame;
  CHECK(run.source.next(frame).code() == StatusCode::EndOfStream);
  CHECK(run.source.next(frame).code() == StatusCode::EndOfStream);
  REQUIRE(run.source.reset().isOk());
  REQUIRE(run.source.next(frame).isOk());
  CHECK(frame.frame == 0);
  CHECK(cv::norm(asMat(frame.left), asMat(run.frames[0].left)) == 0);
}

TEST_CASE("order, first and step reach the frames") {
  const DataFolder data;
  const Run run(with(
      data,
      {{"first", std::int64_t{1}}, {"step", std::int64_t{2}}, {"order", std::string("backward")}}));
  REQUIRE(run.frames.size() == 2);
  CHECK(run.frames[0].source_index == 3);
  CHECK(run.frames[1].source_index == 1);
  CHECK(run.frames[1].stamp_ns == run.frames[0].stamp_ns + 200'000'000);
  CHECK(run.frames[0].T_world_camera_truth.isApprox(Eigen::Isometry3d::Identity()));
  CHECK(run.frames[1].T_world_camera_truth.translation().z() == Approx(-2));
  CHECK(run.info.description.starts_with("KITTI odometry, 2 from 4 stereo pairs"));
}

TEST_CASE("one camera, by wish or because there is no other") {
  const DataFolder data;
  ParameterValues more;
  SECTION("mono: true") { more["mono"] = true; }
  SECTION("no image_1") { data.remove("image_1"); }
  SECTION("nor a matrix of it") {
    data.remove("image_1");
    data.write("calib.txt", matrixLine("P0", 0));
  }
  const Run run(with(data, more));
  CHECK_FALSE(run.info.rig.isStereo());
  CHECK(run.info.description ==
        "KITTI odometry, 4 images of one camera of 64x48 px at 10.0 Hz, with truth");
  REQUIRE(run.frames.size() == 4);
  CHECK_FALSE(run.frames[0].left.empty());
  CHECK(run.frames[0].right.empty());
}

TEST_CASE("the colour pair has its own cameras and its own truth") {
  const DataFolder data;
  for (int i = 0; i < 4; ++i) {
    for (const char* folder : {"image_2/", "image_3/"}) {
      const std::string file = std::string(folder) + "00000" + std::to_string(i) + ".png";
      data.writeImage(file, 64, 48);
      cv::imwrite(data.path(file).string(), cv::Mat(48, 64, CV_8UC3, cv::Scalar(200, 100, 0)));
    }
  }
  data.write("calib.txt", data.read("calib.txt") + matrixLine("P2", 5) + matrixLine("P3", -20));
  // The rig turns left about camera 0 by 90 degrees: camera 2, 0.1 m to its left, moves.
  data.write("poses.txt",
             "1 0 0 0 0 1 0 0 0 0 1 0\n0 0 -1 0 0 1 0 0 1 0 0 0\n"
             "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 0\n");
  SECTION("grey images are preferred without colour") {
    CHECK(Run(with(data)).info.rig.baseline == Approx(0.5));
    const Run run(with(data));
    CHECK(run.frames[1].T_world_camera_truth.translation().norm() == Approx(0).margin(1e-12));
  }
  SECTION("colour") {
    const Run run(with(data, {{"colour", true}}));
    CHECK(run.frames[0].left.format() == PixelFormat::Bgr8);
    CHECK(run.frames[0].left.row(5)[3] == 200);
    CHECK(run.info.rig.baseline == Approx(0.5));
    const Eigen::Vector3d t = run.frames[1].T_world_camera_truth.translation();
    CHECK(t.x() == Approx(0.1));
    CHECK(t.z() == Approx(-0.1));
  }
  SECTION("colour images as grey ones, where there are no others") {
    data.remove("image_0");
    const Run run(with(data));
    CHECK(run.frames[0].left.format() == PixelFormat::Gray8);
    CHECK(run.frames[0].left.row(0)[0] == Approx(0.114 * 200 + 0.587 * 100).margin(1));
  }
}

TEST_CASE("times and truth from elsewhere") {
  const DataFolder data;
  SECTION("a rate instead of times.txt") {
    data.remove("times.txt");
    const Run run(with(data, {{"rate", 3.0}}));
    CHECK(run.frames[1].stamp_ns == 333333333);
    CHECK(run.frames[2].stamp_ns == 666666667);
  }
  SECTION("no truth") {
    data.remove("poses.txt");
    const Run run(with(data));
    CHECK_FALSE(run.info.has_truth);
    CHECK_FALSE(run.frames[0].has_truth);
  }
  SECTION("poses named by the user") {
    std::filesystem::rename(data.path("poses.txt"), data.path("truth.txt"));
    CHECK(Run(with(data, {{"poses", data.path("truth.txt").string()}})).info.has_truth);
  }
  SECTION("poses that are a link to nowhere are an error, not absent") {
    data.remove("poses.txt");
    std::filesystem::create_symlink("nowhere.txt", data.path("poses.txt"));
    KittiSource source;
    CHECK(data.anonymous(configure(source, with(data))) ==
          "DATA/poses.txt: is missing; restore it, or correct the path");
  }
  SECTION("poses where the benchmark has them") {
    for (const char* name : {"image_0", "image_1", "calib.txt", "times.txt"}) {
      std::filesystem::create_directories(data.path("kitti/sequences/06"));
      std::filesystem::rename(data.path(name), data.path("kitti/sequences/06") / name);
    }
    data.write("kitti/poses/06.txt", data.read("poses.txt"));
    for (const char* sequence : {"kitti/sequences/06", "kitti/sequences/06/"}) {
      CHECK(Run({{"path", data.path(sequence).string()}}).info.has_truth);
    }
  }
}

TEST_CASE("inspect describes a sound sequence") {
  const DataFolder data;
  Run run(with(data));
  const std::vector<std::string> findings = inspect(run.source);
  REQUIRE(findings.size() == 1);
  CHECK(data.anonymous(findings[0]) == "note DATA/image_0: " + run.info.description);
}

}  // namespace tolman::image_folders
