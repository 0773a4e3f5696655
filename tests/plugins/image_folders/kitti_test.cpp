// SPDX-License-Identifier: BSD-3-Clause
// KITTI's two layouts: the odometry benchmark and the raw data.
#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "data_folder.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::image_folders {
namespace {

using Kitti = Opened<KittiParameters>;
using KittiRaw = Opened<KittiRawParameters>;

constexpr const char* kCalibration =
    "calib_time: 09-Jan-2012 13:57:47\n"
    "S_00: 80 60\nK_00: 50 0 40 0 50 30 0 0 1\nD_00: -0.1 0 0 0 0\n"
    "R_00: 1 0 0 0 1 0 0 0 1\nT_00: 0 0 0\nS_rect_00: 64 48\n"
    "R_rect_00: 1 0 0 0 1 0 0 0 1\nP_rect_00: 45 0 32 0 0 45 24 0 0 0 1 0\n"
    "S_01: 80 60\nK_01: 50 0 40 0 50 30 0 0 1\nD_01: -0.1 0 0 0 0\n"
    "R_01: 1 0 0 0 1 0 0 0 1\nT_01: -0.5 0 0\nS_rect_01: 64 48\n"
    "R_rect_01: 1 0 0 0 1 0 0 0 1\nP_rect_01: 45 0 32 -22.5 0 45 24 0 0 0 1 0\n";

/// A drive of two pairs of this size; the parameters to read it.
ParameterValues writeDrive(const DataFolder& data, int width, int height) {
  for (const char* camera : {"day/drive/image_00", "day/drive/image_01"}) {
    data.writeImage(std::string(camera) + "/data/0000000000.png", width, height);
    data.writeImage(std::string(camera) + "/data/0000000001.png", width, height, 1);
  }
  data.write("day/calib_cam_to_cam.txt", kCalibration);
  data.write("day/drive/image_00/timestamps.txt",
             "2011-09-26 13:02:25.964389445\n2011-09-26 13:02:26.064389445\n");
  return {{"path", data.path("day/drive").string()}};
}

}  // namespace

TEST_CASE("a sound sequence") {
  const DataFolder data;
  const Kitti run(data);
  CHECK(run.message.empty());
  CHECK(run.findings.empty());
  CHECK(run.info.description ==
        "KITTI odometry, 4 stereo pairs of 64x48 px at 10.0 Hz, baseline 0.5000 m, with truth");
  CHECK(run.info.frames == 4);
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
  Kitti run(data);
  Frame frame;
  CHECK(run.source.next(frame).code() == StatusCode::EndOfStream);
  REQUIRE(run.source.reset().isOk());
  REQUIRE(run.source.next(frame).isOk());
  CHECK(frame.frame == 0);
  CHECK(cv::norm(asMat(frame.left), asMat(run.frames[0].left)) == 0);
}

TEST_CASE("order, first and step reach the frames") {
  const DataFolder data;
  const Kitti run(
      data,
      {{"first", std::int64_t{1}}, {"step", std::int64_t{2}}, {"order", std::string("backward")}});
  REQUIRE(run.frames.size() == 2);
  CHECK(run.frames[0].source_index == 3);
  CHECK(run.frames[1].source_index == 1);
  CHECK(run.frames[1].stamp_ns == run.frames[0].stamp_ns + 200'000'000);
  CHECK(run.frames[0].T_world_camera_truth.isApprox(Eigen::Isometry3d::Identity()));
  CHECK(run.frames[1].T_world_camera_truth.translation().z() == Approx(-2));
  CHECK(run.info.description.starts_with("KITTI odometry, 2 from 4 stereo pairs"));
  const Kitti late(data, {{"first", std::int64_t{4}}});
  CHECK(late.code == StatusCode::InvalidParameter);
}

TEST_CASE("one camera, by wish or because there is no other") {
  const DataFolder data;
  ParameterValues more;
  SECTION("mono: true") { more["mono"] = true; }
  SECTION("no image_1, nor a matrix of it") {
    data.remove("image_1");
    data.write("calib.txt", matrixLine("P0", 0));
  }
  const Kitti run(data, more);
  CHECK_FALSE(run.info.rig.isStereo());
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
    const Kitti run(data);
    CHECK(run.info.rig.baseline == Approx(0.5));
    CHECK(run.frames[1].T_world_camera_truth.translation().norm() == Approx(0).margin(1e-12));
  }
  SECTION("colour") {
    const Kitti run(data, {{"colour", true}});
    CHECK(run.frames[0].left.format() == PixelFormat::Bgr8);
    CHECK(run.frames[0].left.row(5)[3] == 200);
    CHECK(run.info.rig.baseline == Approx(0.5));
    const Eigen::Vector3d t = run.frames[1].T_world_camera_truth.translation();
    CHECK(t.x() == Approx(0.1));
    CHECK(t.z() == Approx(-0.1));
  }
  SECTION("colour images as grey ones, where there are no others") {
    data.remove("image_0");
    const Kitti run(data);
    CHECK(run.frames[0].left.format() == PixelFormat::Gray8);
    CHECK(run.frames[0].left.row(0)[0] == Approx(0.114 * 200 + 0.587 * 100).margin(1));
  }
}

TEST_CASE("times and truth from elsewhere") {
  const DataFolder data;
  SECTION("a rate in place of times.txt") {
    data.remove("times.txt");
    CHECK(Kitti(data).message ==
          "DATA/times.txt: is missing; restore it, or set rate to the frames a second");
    const Kitti run(data, {{"rate", 3.0}});
    CHECK(run.frames[1].stamp_ns == 333333333);
    CHECK(run.frames[2].stamp_ns == 666666667);
  }
  SECTION("no truth") {
    data.remove("poses.txt");
    const Kitti run(data);
    CHECK_FALSE(run.info.has_truth);
    CHECK_FALSE(run.frames[0].has_truth);
  }
  SECTION("poses named by the user") {
    std::filesystem::rename(data.path("poses.txt"), data.path("truth.txt"));
    CHECK(Kitti(data, {{"poses", data.path("truth.txt").string()}}).info.has_truth);
  }
  SECTION("poses that are a link to nowhere are an error, not absent") {
    data.remove("poses.txt");
    std::filesystem::create_symlink("nowhere.txt", data.path("poses.txt"));
    const Kitti run(data);
    REQUIRE(run.findings.size() == 1);
    CHECK_THAT(run.findings[0], Catch::Contains("DATA/poses.txt: is missing"));
    CHECK(run.frames.size() == 4);
  }
  SECTION("poses where the benchmark has them") {
    for (const char* name : {"image_0", "image_1", "calib.txt", "times.txt"}) {
      std::filesystem::create_directories(data.path("kitti/sequences/06"));
      std::filesystem::rename(data.path(name), data.path("kitti/sequences/06") / name);
    }
    data.write("kitti/poses/06.txt", data.read("poses.txt"));
    for (const char* sequence : {"kitti/sequences/06", "kitti/sequences/06/"}) {
      CHECK(Kitti(data, {{"path", data.path(sequence).string()}}).info.has_truth);
    }
  }
}

TEST_CASE("raw images come with raw cameras and prescribed rectified ones") {
  const DataFolder data;
  const KittiRaw run(data, writeDrive(data, 80, 60));
  REQUIRE(run.message.empty());
  REQUIRE(run.raw.cameras.size() == 2);
  CHECK(run.raw.has_rectified);
  CHECK(run.raw.rectified.baseline == 0.5);
  REQUIRE(run.frames.size() == 2);
  CHECK(run.frames[0].stamp_ns == 1317042145964389445);  // date -u -d '2011-09-26 13:02:25' +%s
}

TEST_CASE("images of the rectified size are rectified already") {
  const DataFolder data;
  const KittiRaw run(data, writeDrive(data, 64, 48));
  REQUIRE(run.message.empty());
  CHECK(run.raw.cameras.empty());
  CHECK(run.info.rig.calibrated);
  CHECK(run.info.rig.pinhole.fx == 45);
  CHECK(run.info.rig.isStereo());
}

TEST_CASE("what is wrong with a drive is named") {
  const DataFolder data;
  const ParameterValues values = writeDrive(data, 100, 60);
  CHECK_THAT(KittiRaw(data, values).message,
             Catch::StartsWith("DATA/day/calib_cam_to_cam.txt: is the calibration of images of "
                               "another size"));
  writeDrive(data, 80, 60);
  data.write("day/calib_cam_to_cam.txt", std::string(kCalibration).substr(0, 150));
  CHECK_THAT(KittiRaw(data, values).message, Catch::StartsWith("DATA/day/calib_cam_to_cam.txt"));
  writeDrive(data, 80, 60);
  data.remove("day/drive/image_00/timestamps.txt");
  CHECK(KittiRaw(data, values).message ==
        "DATA/day/drive/image_00/timestamps.txt: is missing; restore it, or correct the path");
  CHECK_THAT(KittiRaw(data).message, Catch::Contains("has neither image_00/data"));
}

}  // namespace tolman::image_folders
