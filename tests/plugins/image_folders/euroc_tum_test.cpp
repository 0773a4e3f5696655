// SPDX-License-Identifier: BSD-3-Clause
// EuRoC's layout, and TUM-VI's; TUM's RGB-D layout with depth and interpolated true poses.
#include <catch2/catch.hpp>
#include <cstring>
#include <opencv2/imgcodecs.hpp>

#include "data_folder.hpp"

namespace tolman::image_folders {
namespace {

using Euroc = Opened<EurocParameters>;
using Tum = Opened<TumParameters>;

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

void writeTum(const DataFolder& data) {
  data.remove("image_0");
  std::string rgb = "# color images\n";
  std::string depth = "# depth maps\n";
  for (int i = 0; i < 3; ++i) {
    const std::string second = std::to_string(1305031102 + i);
    data.writeImage("rgb/" + second + ".10.png", 64, 48, i);
    rgb += second + ".10 rgb/" + second + ".10.png\n";
    const std::string name = "depth/" + second + ".png";
    std::filesystem::create_directories(data.path("depth"));
    cv::imwrite(data.path(name).string(),
                cv::Mat(48, 64, CV_16UC1, cv::Scalar(i == 2 ? 0 : 5000 * (i + 1))));
    depth += second + (i == 1 ? ".5 " : ".11 ") + name + "\n";  // the second is 0.4 s late
  }
  data.write("rgb.txt", rgb);
  data.write("depth.txt", depth);
}

const ParameterValues kSmall = {{"pinhole", std::vector<double>{525, 525, 31.5, 23.5}}};

}  // namespace

TEST_CASE("pairs of one time, with exact stamps and raw cameras") {
  const DataFolder data;
  writeEuroc(data);
  const Euroc pair(data);
  REQUIRE(pair.message.empty());
  REQUIRE(pair.frames.size() == 2);
  CHECK(pair.frames[0].stamp_ns == 1403715273262142976);
  CHECK(pair.frames[1].stamp_ns == 1403715273362142976);
  CHECK_FALSE(pair.frames[1].right.empty());
  CHECK(pair.info.description == "EuRoC, 2 stereo pairs of 64x48 px at 10.0 Hz, not rectified");
  CHECK_FALSE(pair.info.rig.calibrated);
  REQUIRE(pair.raw.cameras.size() == 2);
  CHECK(pair.raw.cameras[1].T_reference_camera.translation().x() == 0.11);
  REQUIRE(pair.findings.size() == 1);
  CHECK(pair.findings[0] ==
        "warning DATA/mav0: 2 images have no partner of the same time and are left out");
  const Euroc mono(data, {{"mono", true}, {"path", data.path("mav0").string()}});
  CHECK(mono.frames.size() == 3);
  CHECK(mono.raw.cameras.size() == 1);
}

TEST_CASE("without tables the names of the images are the stamps, as in TUM-VI") {
  const DataFolder data;
  writeEuroc(data);
  for (const char* camera : {"mav0/cam0", "mav0/cam1"}) {
    std::filesystem::rename(data.path(camera) / "data", data.path(camera) / "images");
    data.remove(std::string(camera) + "/data.csv");
  }
  const Euroc pair(data);
  REQUIRE(pair.frames.size() == 2);
  CHECK(pair.frames[1].stamp_ns == 1403715273362142976);
}

TEST_CASE("what is wrong in EuRoC's layout is named") {
  const DataFolder data;
  CHECK(Euroc(data).message ==
        "DATA/: has no cam0; set path to the folder with mav0, or with cam0");
  writeEuroc(data);
  data.remove("mav0/cam0/sensor.yaml");
  CHECK(Euroc(data).message ==
        "DATA/mav0/camchain.yaml: is missing; restore it, or correct the path");
  data.write("mav0/cam0/sensor.yaml", sensor(0));
  data.write("mav0/cam1/data.csv", "xyz,a.png\n");
  CHECK_THAT(Euroc(data).message,
             Catch::StartsWith("DATA/mav0/cam1/data.csv:1: 'xyz' is no time in ns"));
  data.write("mav0/cam1/data.csv", "5,a.png\n");
  CHECK_THAT(Euroc(data).message, Catch::Contains("has no two images of one time"));
  data.write("mav0/cam1/data.csv",
             "1403715273262142976,1403715273262142976.png\n1403715273262142975,b.png\n");
  const Euroc fallen(data);
  CHECK(fallen.frames.size() == 1);
  REQUIRE(!fallen.findings.empty());
  CHECK(fallen.findings[0] == "error DATA/mav0/cam1/data.csv:2: is no later than the line before");
}

TEST_CASE("names in seconds where nanoseconds are read are reported") {
  const DataFolder data;
  for (const char* name : {"1403715001", "1403715002", "1403715003"}) {
    data.writeImage(std::string("cam0/data/") + name + ".png", 64, 48, 1);
  }
  data.write("cam0/sensor.yaml", sensor(0));
  const Euroc seconds(data, {{"mono", true}});
  REQUIRE(seconds.findings.size() == 1);
  CHECK(seconds.findings[0] ==
        "error DATA/cam0/data: has images 1e-09 s apart (median), so the times are of another "
        "unit");
}

TEST_CASE("depth goes along in metres; images without depth are left out") {
  const DataFolder data;
  writeTum(data);
  const Tum tum(data, kSmall);
  INFO(tum.message);
  REQUIRE(tum.frames.size() == 2);
  CHECK(tum.frames[1].stamp_ns == 1305031104100000000);
  REQUIRE(tum.frames[0].sensors.size() == 1);
  const NamedArray& depth = tum.frames[0].sensors[0];
  CHECK(depth.name == "depth.left");
  CHECK(depth.shape == std::vector<int>{48, 64});
  CHECK(depth.values[100] == 1.0F);
  CHECK(tum.frames[1].sensors[0].values[100] == 0.0F);
  std::vector<ArrayInfo> arrays;
  REQUIRE(tum.source.describe(arrays).isOk());
  REQUIRE(arrays.size() == 1);
  CHECK(arrays[0].kind == ArrayKind::DepthImage);
  REQUIRE(tum.findings.size() == 1);
  CHECK_THAT(tum.findings[0], Catch::Contains("no depth near the time of 1 colour"));
  data.remove("depth.txt");
  const Tum raw(data, {{"pinhole", std::vector<double>{50, 51, 31.5, 23.5, 0.26, -0.95, -0.005}}});
  CHECK_THAT(raw.message, Catch::Contains("coefficients"));  // 3 are of no model
  const std::vector<double> fr1 = {50, 51, 31.5, 23.5, 0.26, -0.95, -0.005, 0.002, 1.16};
  const Tum distorted(data, {{"pinhole", fr1}});
  INFO(distorted.message);
  REQUIRE(distorted.raw.cameras.size() == 1);
  CHECK_FALSE(distorted.info.rig.calibrated);
  CHECK(distorted.raw.cameras[0].model == LensModel::RadialTangential);
  CHECK(distorted.raw.cameras[0].pinhole.fy == 51);
  CHECK(distorted.raw.cameras[0].distortion[4] == 1.16);
  const Tum plain(data, {{"pinhole", std::vector<double>{50, 50, 31.5, 23.5}}});
  CHECK(plain.frames.size() == 3);
  CHECK(plain.frames[0].sensors.empty());
  CHECK(plain.info.rig.pinhole.fx == 50);
}

TEST_CASE("a depth image that cannot be used gives a frame without images") {
  const auto defectOf = [](const cv::Mat& first) {
    const DataFolder data;
    writeTum(data);
    cv::imwrite(data.path("depth/1305031102.png").string(), first);
    const Tum tum(data, kSmall);
    REQUIRE(tum.frames.size() == 2);
    CHECK(tum.frames[0].left.empty() == !tum.frames[0].defect.empty());
    CHECK(tum.frames[0].sensors.size() == 1);
    return data.anonymous(tum.frames[0].defect);
  };
  CHECK(defectOf(cv::Mat::zeros(48, 64, CV_16UC1)).empty());
  CHECK(defectOf(cv::Mat::zeros(24, 32, CV_16UC1)) ==
        "DATA/depth/1305031102.png: has 32x24 pixels, but the images have 64x48 pixels");
  CHECK(defectOf(cv::Mat::zeros(48, 64, CV_8UC1)) ==
        "DATA/depth/1305031102.png: has no single channel of 16 bits; it is no depth image");
}

TEST_CASE("a list of images of another form is refused") {
  const DataFolder data;
  writeTum(data);
  data.write("rgb.txt", "12 a b\n");
  CHECK(Tum(data).message == "DATA/rgb.txt:1: is not 'TIME FILE'; correct it");
}

TEST_CASE("ten pairs of EuRoC V1_01, and four of TUM-VI of 16 bits", "[data]") {
  const DataFolder data;
  if (const auto path = test::dataOrSkip("euroc_v101")) {
    const Euroc pair(data, {{"path", path->string()}});
    REQUIRE(pair.frames.size() == 10);
    CHECK(pair.findings.empty());
    CHECK(pair.frames[1].stamp_ns == 1403715273312143104);
    const cv::Mat expected = cv::imread((*path / "mav0/cam1/data/1403715273312143104.png").string(),
                                        cv::IMREAD_GRAYSCALE);
    const Image& right = pair.frames[1].right;
    CHECK(std::memcmp(right.data(), expected.data, static_cast<std::size_t>(752 * 480)) == 0);
  }
  if (const auto path = test::dataOrSkip("tumvi_room1")) {
    const Euroc pair(data, {{"path", path->string()}});
    REQUIRE(pair.frames.size() == 4);
    CHECK(pair.frames[3].stamp_ns == 1520530308349502521);
    const cv::Mat deep =
        cv::imread((*path / "cam0/images/1520530308349502521.png").string(), cv::IMREAD_UNCHANGED);
    REQUIRE(deep.type() == CV_16UC1);
    int different = 0;
    for (int r = 0; r < deep.rows; ++r) {
      for (int c = 0; c < deep.cols; ++c) {
        different += pair.frames[3].left.row(r)[c] != deep.at<std::uint16_t>(r, c) / 256 ? 1 : 0;
      }
    }
    CHECK(different == 0);
  }
}

TEST_CASE("ten images of TUM fr1/xyz with depth", "[data]") {
  const auto path = test::dataOrSkip("tum_fr1_xyz");
  if (!path) return;
  const DataFolder data;
  const Tum tum(data, {{"path", path->string()}});
  REQUIRE(tum.frames.size() == 10);
  CHECK(tum.frames[0].stamp_ns == 1305031102175304000);
  const cv::Mat deep =
      cv::imread((*path / "depth/1305031102.160407.png").string(), cv::IMREAD_UNCHANGED);
  const std::vector<float>& depth = tum.frames[0].sensors[0].values;
  for (const int i : {100000, 153600, 200000}) {
    CHECK(depth[static_cast<std::size_t>(i)] ==
          Approx(deep.at<std::uint16_t>(i / 640, i % 640) / 5000.0));
  }
}

}  // namespace tolman::image_folders
