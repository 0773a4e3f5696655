// SPDX-License-Identifier: BSD-3-Clause
// EuRoC's layout, and TUM-VI's.
#include "euroc_source.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <opencv2/imgcodecs.hpp>

#include "data_folder.hpp"

namespace tolman::image_folders {
namespace {

std::string sensor(double x) {
  return "%YAML:1.0\nsensor_type: camera\nT_BS:\n  cols: 4\n  rows: 4\n  data: [1, 0, 0, " +
         std::to_string(x) +
         ", 0, 1, 0, 0, 0, 0, 1, 0,\n    0, 0, 0, 1]\nresolution: [64, 48]\n"
         "camera_model: pinhole\nintrinsics: [50, 51, 31, 23] #fu, fv, cu, cv\n"
         "distortion_model: radial-tangential\ndistortion_coefficients: [-0.1, 0.01, 0, 0]\n";
}

/// Three times in each camera; one of each has no partner.
void writeEuroc(const DataFolder& data) {
  const char* const stamps[2][3] = {
      {"1403715273262142976", "1403715273312143104", "1403715273362142976"},
      {"1403715273262142976", "1403715273362142976", "1403715273412143104"}};
  for (int camera = 0; camera < 2; ++camera) {
    const std::string folder = "mav0/cam" + std::to_string(camera) + "/";
    std::string table = "#timestamp [ns],filename\r\n";
    for (int i = 0; i < 3; ++i) {
      const std::string name = std::string(stamps[camera][i]) + ".png";
      data.writeImage(folder + "data/" + name, 64, 48, 3 * camera + i);
      table += std::string(stamps[camera][i]) + "," + name + "\r\n";
    }
    data.write(folder + "data.csv", table);
    data.write(folder + "sensor.yaml", sensor(0.11 * camera));
  }
}

struct EurocOpened {
  EurocOpened(const DataFolder& data, ParameterValues values = {}) {
    if (!values.contains("path")) values["path"] = data.path().string();
    message = data.anonymous(configure(source, std::move(values)));
    if (!message.empty()) return;
    REQUIRE(source.info(info).isOk());
    REQUIRE(source.rawRig(rig).isOk());
    frames = readAll(source, failure);
  }
  EurocSource source;
  SourceInfo info;
  RawRig rig;
  std::string message;
  std::string failure;
  std::vector<Frame> frames;
};

}  // namespace

TEST_CASE("pairs of one time, with exact stamps and raw cameras") {
  const DataFolder data;
  writeEuroc(data);
  const EurocOpened pair(data);
  REQUIRE(pair.message.empty());
  REQUIRE(pair.frames.size() == 2);
  CHECK(pair.frames[0].stamp_ns == 1403715273262142976);
  CHECK(pair.frames[1].stamp_ns == 1403715273362142976);
  CHECK_FALSE(pair.frames[1].right.empty());
  CHECK(pair.info.description ==
        "EuRoC, 2 stereo pairs of 64x48 px at 10.0 Hz, not rectified, no truth");
  CHECK_FALSE(pair.info.rig.calibrated);
  CHECK(pair.info.rig.width == 64);
  REQUIRE(pair.rig.cameras.size() == 2);
  CHECK(pair.rig.cameras[1].T_reference_camera.translation().x() == 0.11);
  const EurocOpened mono(data, {{"mono", true}, {"path", data.path("mav0").string()}});
  CHECK(mono.frames.size() == 3);
  CHECK(mono.rig.cameras.size() == 1);
}

TEST_CASE("without tables the names of the images are the stamps, as in TUM-VI") {
  const DataFolder data;
  writeEuroc(data);
  for (const char* camera : {"mav0/cam0", "mav0/cam1"}) {
    std::filesystem::rename(data.path(camera) / "data", data.path(camera) / "images");
    data.remove(std::string(camera) + "/data.csv");
  }
  const EurocOpened pair(data);
  REQUIRE(pair.frames.size() == 2);
  CHECK(pair.frames[1].stamp_ns == 1403715273362142976);
}

TEST_CASE("names in seconds: the unit is named, and the parameter that sets it") {
  const auto write = [](const DataFolder& data, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      data.writeImage("cam0/data/" + name + ".png", 64, 48, 1);
    }
    data.write("cam0/sensor.yaml", sensor(0));
  };
  const std::string remedy =
      "is their unit another than ns? Set stamps_unit (of `images`; `euroc` reads nanoseconds, so "
      "use `images` with stamps_in_names for other units)";
  const DataFolder whole;
  write(whole, {"1403715001", "1403715002", "1403715003"});
  EurocOpened seconds(whole, {{"mono", true}});
  REQUIRE(seconds.message.empty());
  const auto findings = inspect(seconds.source);
  REQUIRE(findings.size() == 2);
  CHECK_THAT(findings[0], Catch::Contains("has images 1 ns apart (median), more than 10000 a "
                                          "second, by times in ns; " +
                                          remedy));
  const DataFolder decimals;
  write(decimals, {"1403715273.262142", "1403715273.312142", "1403715273.362142"});
  CHECK_THAT(EurocOpened(decimals, {{"mono", true}}).message,
             Catch::Contains("its name is the same time as that of 1403715273.262142.png, because "
                             "times in ns are rounded to whole nanoseconds; " +
                             remedy));
}

TEST_CASE("what is missing in EuRoC's layout is named") {
  const DataFolder data;
  CHECK(EurocOpened(data).message ==
        "DATA/: has no cam0; set path to the folder with mav0, or with cam0");
  writeEuroc(data);
  data.remove("mav0/cam0/sensor.yaml");
  CHECK(EurocOpened(data).message ==
        "DATA/mav0/camchain.yaml: is missing; restore it, or correct the path");
  data.write("mav0/cam0/sensor.yaml", sensor(0));
  data.write("mav0/cam1/data.csv", "1403715273262142976,a.png\n1403715273262142975,b.png\n");
  CHECK(EurocOpened(data).message ==
        "DATA/mav0/cam1/data.csv:2: is no later than the line before; sort the file");
  data.write("mav0/cam1/data.csv", "14037152732621429.5e9,../../a.png\n");
  CHECK_THAT(EurocOpened(data).message, Catch::Contains("is not of the form 'nanoseconds,image'"));
  for (const char* time : {"1403715273.262142976", "1.403715273e18"}) {
    data.write("mav0/cam1/data.csv", std::string(time) + ",a.png\n" + time + ",b.png\n");
    CHECK_THAT(EurocOpened(data).message, Catch::Contains("with whole nanoseconds"));
  }
  data.write("mav0/cam1/data.csv", "5,a.png\n");
  CHECK_THAT(EurocOpened(data).message, Catch::Contains("has no two images of one time"));
}

TEST_CASE("a rate_hz that the times contradict is told, jitter and lost images are not") {
  const DataFolder data;
  writeEuroc(data);
  const auto warningsFor = [&](const std::string& rate) {
    data.write("mav0/cam0/sensor.yaml", sensor(0) + "rate_hz: " + rate + "\n");
    EurocOpened mono(data, {{"mono", true}});
    REQUIRE(mono.message.empty());
    auto findings = inspect(mono.source);
    findings.pop_back();  // the description
    return findings;
  };
  CHECK(warningsFor("20").empty());
  CHECK(warningsFor("25").empty());
  const auto findings = warningsFor("200");
  REQUIRE(findings.size() == 1);
  CHECK(data.anonymous(findings[0]) ==
        "note DATA/mav0/cam0/sensor.yaml:13: rate_hz is 200.0, but the images are at 20.0 Hz by "
        "their times (median), which are used; if the times are right, correct rate_hz, otherwise "
        "the times");
  CHECK(warningsFor("2").size() == 1);
}

TEST_CASE("ten pairs of EuRoC V1_01: stamps, pixels and warnings", "[data]") {
  const auto path = test::dataOrSkip("euroc_v101");
  if (!path) return;
  const DataFolder data;
  EurocOpened pair(data, {{"path", path->string()}});
  REQUIRE(pair.message.empty());
  REQUIRE(pair.frames.size() == 10);
  CHECK(pair.frames[1].stamp_ns == 1403715273312143104);
  CHECK(inspect(pair.source).size() == 1);
  const cv::Mat expected =
      cv::imread((*path / "mav0/cam1/data/1403715273312143104.png").string(), cv::IMREAD_GRAYSCALE);
  const Image& right = pair.frames[1].right;
  CHECK(std::memcmp(right.data(), expected.data, static_cast<std::size_t>(752 * 480)) == 0);
}

TEST_CASE("four pairs of TUM-VI of 16 bits: stamps and the high bytes", "[data]") {
  const auto path = test::dataOrSkip("tumvi_room1");
  if (!path) return;
  const DataFolder data;
  const EurocOpened pair(data, {{"path", path->string()}});
  REQUIRE(pair.message.empty());
  REQUIRE(pair.frames.size() == 4);
  CHECK(pair.frames[3].stamp_ns == 1520530308349502521);
  const cv::Mat deep =
      cv::imread((*path / "cam0/images/1520530308349502521.png").string(), cv::IMREAD_UNCHANGED);
  REQUIRE(deep.type() == CV_16UC1);
  const Image& left = pair.frames[3].left;
  int different = 0;
  for (int r = 0; r < deep.rows; ++r) {
    for (int c = 0; c < deep.cols; ++c) {
      different += left.row(r)[c] != deep.at<std::uint16_t>(r, c) / 256 ? 1 : 0;
    }
  }
  CHECK(different == 0);
}

}  // namespace tolman::image_folders
