// SPDX-License-Identifier: BSD-3-Clause
// A drive of KITTI's raw data, before and after rectification.
#include "kitti_raw_source.hpp"

#include <catch2/catch.hpp>

#include "data_folder.hpp"
#include "dates.hpp"

namespace tolman::image_folders {
namespace {

constexpr const char* kCalibration =
    "calib_time: 09-Jan-2012 13:57:47\n"
    "S_00: 80 60\nK_00: 50 0 40 0 50 30 0 0 1\nD_00: -0.1 0 0 0 0\n"
    "R_00: 1 0 0 0 1 0 0 0 1\nT_00: 0 0 0\nS_rect_00: 64 48\n"
    "R_rect_00: 1 0 0 0 1 0 0 0 1\nP_rect_00: 45 0 32 0 0 45 24 0 0 0 1 0\n"
    "S_01: 80 60\nK_01: 50 0 40 0 50 30 0 0 1\nD_01: -0.1 0 0 0 0\n"
    "R_01: 1 0 0 0 1 0 0 0 1\nT_01: -0.5 0 0\nS_rect_01: 64 48\n"
    "R_rect_01: 1 0 0 0 1 0 0 0 1\nP_rect_01: 45 0 32 -22.5 0 45 24 0 0 0 1 0\n";

void writeDrive(const DataFolder& data, int width, int height) {
  for (const char* camera : {"day/drive/image_00", "day/drive/image_01"}) {
    data.writeImage(std::string(camera) + "/data/0000000000.png", width, height);
    data.writeImage(std::string(camera) + "/data/0000000001.png", width, height, 1);
  }
  data.write("day/calib_cam_to_cam.txt", kCalibration);
  data.write("day/drive/image_00/timestamps.txt",
             "2011-09-26 13:02:25.964389445\n2011-09-26 13:02:26.064389445\n");
}

std::string open(const DataFolder& data, KittiRawSource& source) {
  return data.anonymous(configure(source, {{"path", data.path("day/drive").string()}}));
}

/// The refusal of the calibration with one piece replaced; empty if it is accepted.
std::string refusal(const std::string& from, const std::string& to, bool mono = false) {
  const DataFolder data;
  writeDrive(data, 80, 60);
  std::string text = kCalibration;
  REQUIRE(text.find(from) != std::string::npos);
  data.write("day/calib_cam_to_cam.txt", text.replace(text.find(from), from.size(), to));
  KittiRawSource source;
  return data.anonymous(
      configure(source, {{"path", data.path("day/drive").string()}, {"mono", mono}}));
}

}  // namespace

TEST_CASE("raw images come with raw cameras and prescribed rectified ones") {
  const DataFolder data;
  writeDrive(data, 80, 60);
  KittiRawSource source;
  REQUIRE(open(data, source).empty());
  RawRig rig;
  REQUIRE(source.rawRig(rig).isOk());
  REQUIRE(rig.cameras.size() == 2);
  CHECK(rig.has_rectified);
  CHECK(rig.rectified.baseline == 0.5);
  std::string failure;
  const auto frames = readAll(source, failure);
  REQUIRE(frames.size() == 2);
  CHECK(frames[0].stamp_ns == 1317042145964389445);  // date -u -d '2011-09-26 13:02:25' +%s
}

TEST_CASE("images of the rectified size are rectified already") {
  const DataFolder data;
  writeDrive(data, 64, 48);
  KittiRawSource source;
  REQUIRE(open(data, source).empty());
  RawRig rig;
  REQUIRE(source.rawRig(rig).isOk());
  CHECK(rig.cameras.empty());
  SourceInfo info;
  REQUIRE(source.info(info).isOk());
  CHECK(info.rig.calibrated);
  CHECK(info.rig.pinhole.fx == 45);
  CHECK(info.rig.isStereo());
}

TEST_CASE("a pair whose entries contradict each other is refused, with keys and values") {
  CHECK_THAT(
      refusal("32 -22.5", "32 -2.25"),
      Catch::StartsWith("DATA/day/calib_cam_to_cam.txt:17: P_rect_00 and P_rect_01 place the "
                        "right camera at (0.05, 0, 0) m from the left one, but T_00 and "
                        "T_01 at (0.5, 0, 0) m"));
  CHECK_THAT(refusal("P_rect_00: 45 0 32 0", "P_rect_00: 45 0 32 2.8"),
             Catch::Contains("at (0.5622, 0, 0) m from the left one"));
  CHECK_THAT(refusal("T_01: -0.5", "T_01: -500"), Catch::Contains("at (500, 0, 0) m"));
  CHECK_THAT(
      refusal("R_rect_01: 1 0 0 0 1 0 0 0 1", "R_rect_01: 1 0 0 0 0.99995 -0.01 0 0.01 0.99995"),
      Catch::StartsWith("DATA/day/calib_cam_to_cam.txt:16: R_rect_01 R_01 and R_rect_00 R_00 are "
                        "0.573 degrees apart"));
  CHECK_THAT(refusal("S_rect_01: 64 48", "S_rect_01: 60 48"),
             Catch::StartsWith("DATA/day/calib_cam_to_cam.txt:15: S_rect_01 is 60x48 px, but "
                               "S_rect_00 64x48 px"));
  CHECK(refusal("32 -22.5", "32 -2.25", true).empty());  // one camera has no baseline
}

TEST_CASE("a pair that is consistent but for a per cent, or turned and turned back, is accepted") {
  CHECK(refusal("32 -22.5", "32 -22.8").empty());
  CHECK(refusal("R_01: 1 0 0 0 1 0 0 0 1\nT_01: -0.5 0 0\nS_rect_01: 64 48\n"
                "R_rect_01: 1 0 0 0 1 0 0 0 1",
                "R_01: 1 0 0 0 0.99995 -0.01 0 0.01 0.99995\nT_01: -0.5 0 0\nS_rect_01: 64 48\n"
                "R_rect_01: 1 0 0 0 0.99995 0.01 0 -0.01 0.99995")
            .empty());
}

TEST_CASE("matrices with skew or another scale, and a lower right camera, are refused") {
  const std::string file = "DATA/day/calib_cam_to_cam.txt:";
  CHECK_THAT(refusal("K_00: 50 0 40", "K_00: 50 3 40"),
             Catch::StartsWith(file + "3: K_00 has other numbers than 0 for the skew"));
  CHECK_THAT(refusal("K_01: 50 0 40 0 50 30 0 0 1", "K_01: 50 0 40 0 50 30 0 0 2"),
             Catch::StartsWith(file + "11: K_01 has"));
  CHECK_THAT(refusal("-22.5 0 45 24 0 0 0 1 0", "-22.5 0 45 24 0 0 0 2 0"),
             Catch::StartsWith(file + "17: P_rect_01 has"));
  CHECK_THAT(refusal("-22.5 0 45 24 0", "-22.5 0 45 24 0.6"),
             Catch::StartsWith(file + "17: the rectified right camera is -0.01333 m below"));
}

TEST_CASE("right images of other times than the left ones are told") {
  const DataFolder data;
  writeDrive(data, 80, 60);
  const auto warningsFor = [&](const std::string& right) {
    data.write("day/drive/image_01/timestamps.txt", right);
    KittiRawSource source;
    REQUIRE(open(data, source).empty());
    auto findings = inspect(source);
    findings.pop_back();  // the description
    return findings;
  };
  CHECK(warningsFor("2011-09-26 13:02:25.9643\n2011-09-26 13:02:26.0643\n").empty());
  CHECK(warningsFor("2011-09-26 13:02:25.9643\n2011-09-26 13:02:xx\n").empty());
  const auto findings =
      warningsFor("2011-09-26 13:04:25.964389445\n2011-09-26 13:04:26.064389445\n");
  REQUIRE(findings.size() == 1);
  CHECK_THAT(data.anonymous(findings[0]),
             Catch::Contains("DATA/day/drive/image_01/timestamps.txt: puts right image 0 120.000 s "
                             "behind the left one"));
}

TEST_CASE("other sizes, missing times and broken dates are named") {
  const DataFolder data;
  writeDrive(data, 100, 60);
  KittiRawSource source;
  CHECK_THAT(open(data, source), Catch::StartsWith("DATA/day/calib_cam_to_cam.txt: is of images "
                                                   "of another size"));
  writeDrive(data, 80, 60);
  data.write("day/calib_cam_to_cam.txt", std::string(kCalibration).substr(0, 150));
  CHECK_THAT(open(data, source), Catch::StartsWith("DATA/day/calib_cam_to_cam.txt"));
  writeDrive(data, 80, 60);
  data.remove("day/drive/image_00/timestamps.txt");
  CHECK_THAT(open(data, source), Catch::Contains("set rate to the frames a second"));
  for (const char* date : {"2011-13-26 13:02:25.9", "2011-09-26", "2011-09-26 25:02:25",
                           "2011-02-30 13:02:25", "2011-09-26 13:02:xx"}) {
    data.write("dates.txt", std::string(date) + "\n");
    Inspection inspection;
    (void)readDates(data.path("dates.txt"), inspection);
    CHECK(inspection.hasErrors());
  }
}

}  // namespace tolman::image_folders
