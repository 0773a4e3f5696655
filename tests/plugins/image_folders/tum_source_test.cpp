// SPDX-License-Identifier: BSD-3-Clause
// TUM's RGB-D layout: colour and depth with different times, interpolated true poses.
#include "tum_source.hpp"

#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "data_folder.hpp"
#include "tum_poses.hpp"

namespace tolman::image_folders {
namespace {

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

struct TumOpened {
  explicit TumOpened(const std::filesystem::path& path, ParameterValues values = {}) {
    values["path"] = path.string();
    message = configure(source, std::move(values));
    if (!message.empty()) return;
    REQUIRE(source.info(info).isOk());
    frames = readAll(source, failure);
  }
  TumSource source;
  SourceInfo info;
  std::string message;
  std::string failure;
  std::vector<Frame> frames;
};

const ParameterValues kSmall = {{"cx", 31.5}, {"cy", 23.5}};

}  // namespace

TEST_CASE("depth goes along in metres; images without depth are left out") {
  const DataFolder data;
  writeTum(data);
  TumOpened tum(data.path(), kSmall);
  INFO(tum.message << tum.failure);
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
  const auto findings = inspect(tum.source);
  CHECK_THAT(data.anonymous(findings[0]), Catch::Contains("no depth near the time of 1 colour"));
  const TumOpened plain(data.path(), {{"depth", false}, {"cx", 31.5}, {"cy", 23.5}, {"fx", 50.0}});
  CHECK(plain.frames.size() == 3);
  CHECK(plain.frames[0].sensors.empty());
  CHECK(plain.info.rig.pinhole.fx == 50);
}

TEST_CASE("inspect tells of depth files that a run would not take") {
  const auto errors = [](const cv::Mat& first, bool keeps_last) {
    const DataFolder data;
    writeTum(data);
    cv::imwrite(data.path("depth/1305031102.png").string(), first);
    if (!keeps_last) data.remove("depth/1305031104.png");
    TumOpened tum(data.path(), kSmall);
    std::string text;
    for (const std::string& finding : inspect(tum.source)) {
      if (finding.starts_with("error")) text += data.anonymous(finding) + "\n";
    }
    return text;
  };
  CHECK(errors(cv::Mat::zeros(48, 64, CV_16UC1), true).empty());
  CHECK(errors(cv::Mat::zeros(48, 64, CV_16UC1), false) ==
        "error DATA/depth/1305031104.png: is missing or no file; copy or record it again, or leave "
        "it out by on_corrupt: skip\n");
  CHECK(
      errors(cv::Mat::zeros(24, 32, CV_16UC1), true) ==
      "error DATA/depth/1305031102.png: has 32x24 pixels, but the first image has 64x48; all must "
      "be of one size\n");
  CHECK_THAT(errors(cv::Mat::zeros(48, 64, CV_8UC1), true),
             Catch::StartsWith("error DATA/depth/1305031102.png: has no single channel of 16 bits; "
                               "it is no depth image"));
}

TEST_CASE("true poses lie between the measured ones") {
  StampedPoses poses;
  poses.stamps_ns = {1000, 2000};
  poses.T_world_camera.resize(2, Eigen::Isometry3d::Identity());
  poses.T_world_camera[1].translation().x() = 4;
  poses.T_world_camera[1].linear() = Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitZ()).matrix();
  const auto pose = poseAt(poses, 1250, 800);
  REQUIRE(pose);
  CHECK(pose->translation().x() == Approx(1));
  CHECK(Eigen::AngleAxisd(pose->linear()).angle() == Approx(0.2));
  CHECK(poseAt(poses, 1000, 0)->translation().x() == 0);
  CHECK_FALSE(poseAt(poses, 999, 800).has_value());
  CHECK_FALSE(poseAt(poses, 2001, 800).has_value());
  CHECK_FALSE(poseAt(poses, 1250, 700).has_value());
}

TEST_CASE("the truth of another recording is an error, one that misses some images a warning") {
  const DataFolder data;
  writeTum(data);
  data.write("groundtruth.txt", "1405031102.1 0 0 0 0 0 0 1\n1405031102.2 0 0 0 0 0 0 1\n");
  CHECK_THAT(data.anonymous(TumOpened(data.path(), kSmall).message),
             Catch::StartsWith("DATA/groundtruth.txt: has no pose near the time of any image"));
  data.write("groundtruth.txt", "1305031101.9 0 0 0 0 0 0 1\n1305031104.9 0 0 0 0 0 0 1\n");
  CHECK_THAT(
      data.anonymous(TumOpened(data.path(), kSmall).message),
      Catch::StartsWith("DATA/groundtruth.txt: has no poses on both sides of the time of any "
                        "image within 0.020 s, although it is of the same time; set "
                        "most_apart"));
  data.write("groundtruth.txt", "1305031102.09 0 0 0 0 0 0 1\n1305031102.11 0 0 0 0 0 0 1\n");
  TumOpened some(data.path(), kSmall);
  CHECK(some.message.empty());
  CHECK_FALSE(some.info.has_truth);
}

TEST_CASE("broken lists and poses are named with their line") {
  const DataFolder data;
  writeTum(data);
  data.write("groundtruth.txt", "1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 2\n");
  CHECK_THAT(data.anonymous(TumOpened(data.path()).message),
             Catch::StartsWith("DATA/groundtruth.txt:2: is no pose"));
  data.write("rgb.txt", "12 ../../etc/x.png\n");
  CHECK_THAT(data.anonymous(TumOpened(data.path()).message),
             Catch::StartsWith("DATA/rgb.txt:1: is not of the form 'seconds file'"));
}

TEST_CASE("ten images of TUM fr1/xyz with depth and truth", "[data]") {
  const auto path = test::dataOrSkip("tum_fr1_xyz");
  if (!path) return;
  TumOpened tum(*path);
  INFO(tum.message);
  REQUIRE(tum.frames.size() == 10);
  CHECK(tum.frames[0].stamp_ns == 1305031102175304000);
  CHECK(tum.info.has_truth);
  const cv::Mat deep =
      cv::imread((*path / "depth/1305031102.160407.png").string(), cv::IMREAD_UNCHANGED);
  const std::vector<float>& depth = tum.frames[0].sensors[0].values;
  for (const int i : {100000, 153600, 200000}) {
    CHECK(depth[static_cast<std::size_t>(i)] ==
          Approx(deep.at<std::uint16_t>(i / 640, i % 640) / 5000.0));
  }
  // Hand-held: some centimetres in a third of a second.
  const double moved = tum.frames[9].T_world_camera_truth.translation().norm();
  CHECK(moved > 0.01);
  CHECK(moved < 0.3);
}

}  // namespace tolman::image_folders
