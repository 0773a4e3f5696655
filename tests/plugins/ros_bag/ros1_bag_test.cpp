// SPDX-License-Identifier: BSD-3-Clause
// Bags that ROS 1's own Python modules (Debian: python3-rosbag) write from real clips: images bit
// for bit, stamps exact, calibration to the last digit.
#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "bag_case.hpp"
#include "support/ros1_tool.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::ros_bag {
namespace {

namespace fs = std::filesystem;

const std::vector<double> kIdentity = {1, 0, 0, 0, 1, 0, 0, 0, 1};

std::vector<fs::path> imagesOf(const fs::path& folder, std::size_t most) {
  std::vector<fs::path> files(fs::directory_iterator(folder), {});
  std::sort(files.begin(), files.end());
  files.resize(std::min(files.size(), most));
  return files;
}

std::string pixelsOf(const cv::Mat& image) {
  return {reinterpret_cast<const char*>(image.data), image.total() * image.elemSize()};
}

/// The pictures and stamps of EuRoC V1_01 and its calibration, as its authors give both.
struct EurocClip {
  EurocClip(const fs::path& mav0, test::Ros1List& list) {
    for (const int camera : {0, 1}) {
      const fs::path folder = mav0 / ("cam" + std::to_string(camera)) / "data";
      const std::string topic = "/cam" + std::to_string(camera) + "/image_raw";
      for (const fs::path& file : imagesOf(folder, 8)) {
        const cv::Mat image = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
        const std::int64_t stamp = std::stoll(file.stem().string());
        list.image(topic, stamp, image.cols, image.rows, "mono8", pixelsOf(image));
        pictures[static_cast<std::size_t>(camera)].push_back(image);
        if (camera == 0) stamps.push_back(stamp);
      }
    }
    list.camera("/cam0/camera_info", 752, 480, "plumb_bob", kLeftD, kLeftK, kIdentity, kP);
    std::vector<double> right = kP;
    right[3] = -48.0123456789012345;
    list.camera("/cam1/camera_info", 752, 480, "plumb_bob", {-0.28, 0.074, 2e-4, 1.76e-5},
                {457.587, 0, 379.999, 0, 456.134, 255.238, 0, 0, 1}, kIdentity, right);
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      const double n = static_cast<double>(i);
      list.imu("/imu0", stamps[i] - 1'000'000, {0.1 * n, 0.2, 1.0 / 3, 9.81, -n, 0.01});
      list.odometry("/odom", stamps[i], 0.1 * n, 0, 0);
      list.text("/chatter", stamps[i], "hello");
    }
  }
  static inline const std::vector<double> kLeftD = {-0.28340811, 0.07395907, 0.00019359,
                                                    1.76187114e-05};
  static inline const std::vector<double> kLeftK = {458.654, 0, 367.215, 0, 457.296,
                                                    248.375, 0, 0,       1};
  static inline const std::vector<double> kP = {435.2046959714599,
                                                0,
                                                367.4517211914062,
                                                0,
                                                0,
                                                435.2046959714599,
                                                252.2008514404297,
                                                0,
                                                0,
                                                0,
                                                1,
                                                0};
  std::array<std::vector<cv::Mat>, 2> pictures;
  std::vector<std::int64_t> stamps;
};

}  // namespace

TEST_CASE("a stereo bag of ROS 1 in each compression", "[data]") {
  const auto data = test::dataOrSkip("euroc_v101/mav0");
  if (!data || !test::ros1OrSkip()) return;
  const test::TemporaryFolder folder;
  test::Ros1List list(folder.path());
  const EurocClip clip(*data, list);
  for (const char* compression : {"none", "bz2", "lz4"}) {
    const fs::path bag = folder.path() / "room.bag";
    REQUIRE(list.call("bag", bag, compression));
    Played played(bag);
    CHECK(played.message.empty());
    REQUIRE(played.frames.size() == clip.stamps.size());
    for (std::size_t i = 0; i < played.frames.size(); ++i) {
      const Frame& frame = played.frames[i];
      CHECK(frame.stamp_ns == clip.stamps[i]);
      CHECK(cv::norm(asMat(frame.left), clip.pictures[0][i], cv::NORM_INF) == 0);
      CHECK(cv::norm(asMat(frame.right), clip.pictures[1][i], cv::NORM_INF) == 0);
    }
    RawRig rig;
    REQUIRE(played.source.rawRig(rig).isOk());
    REQUIRE(rig.cameras.size() == 2);
    CHECK(rig.cameras[0].pinhole.fx == EurocClip::kLeftK[0]);
    CHECK(rig.cameras[0].pinhole.cy == EurocClip::kLeftK[5]);
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(rig.cameras[0].distortion[static_cast<int>(i)] == EurocClip::kLeftD[i]);
    }
    CHECK(rig.rectified.pinhole.fx == EurocClip::kP[0]);
    CHECK(rig.rectified.pinhole.cx == EurocClip::kP[2]);
    CHECK(rig.rectified.baseline == 48.0123456789012345 / EurocClip::kP[0]);
    CHECK(played.info.description ==
          "ROS 1 bag, 8 stereo pairs of /cam0/image_raw and /cam1/image_raw, 752x480 px, raw");
  }
}

TEST_CASE("sensors and topics of a ROS 1 bag", "[data]") {
  const auto data = test::dataOrSkip("euroc_v101/mav0");
  if (!data || !test::ros1OrSkip()) return;
  const test::TemporaryFolder folder;
  test::Ros1List list(folder.path());
  const EurocClip clip(*data, list);
  REQUIRE(list.call("bag", folder.path() / "room.bag", "lz4"));
  Played played(folder.path());  // the folder that it is in
  REQUIRE(played.frames.size() == 8);
  const auto sensor = [&](const std::string& name) {
    for (const NamedArray& array : played.frames[3].sensors) {
      if (array.name == name) return array.values;
    }
    return std::vector<float>();
  };
  CHECK(sensor("imu.angular_velocity") ==
        std::vector<float>{static_cast<float>(0.1 * 3), 0.2F, static_cast<float>(1.0 / 3)});
  CHECK(sensor("imu.linear_acceleration") == std::vector<float>{9.81F, -3, 0.01F});
  REQUIRE(sensor("motion.planar").size() == 3);
  CHECK(sensor("motion.planar")[0] == Approx(0.1));
  const auto has = [&](const std::string& text) {
    const auto& findings = played.context.findings;
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) {
      return (finding.where + ": " + finding.message).find(text) != std::string::npos;
    });
  };
  CHECK(has("/cam0/image_raw: sensor_msgs/msg/Image, 8 messages at 20 Hz"));
  CHECK(has("752x480 mono8, used as left"));
  CHECK(has("/chatter: std_msgs/msg/String, 8 messages"));
  CHECK(has("/imu0: sensor_msgs/msg/Imu, 8 messages at 20 Hz, 0.00"));
  CHECK(has("used as odometry"));
}

TEST_CASE("one camera with compressed images, and a choice of cameras", "[data]") {
  const auto data = test::dataOrSkip("kitti_clips/03_left");
  if (!data || !test::ros1OrSkip()) return;
  const test::TemporaryFolder folder;
  test::Ros1List list(folder.path());
  std::vector<cv::Mat> pictures;
  for (const fs::path& file : imagesOf(*data / "image_0", 6)) {
    const auto stamp = stampOf(static_cast<int>(pictures.size()));
    list.compressed("/front/image/compressed", stamp, "jpeg", file);
    pictures.push_back(cv::imread(file.string(), cv::IMREAD_GRAYSCALE));
  }
  list.image("/rear/image", stampOf(0), 4, 2, "mono8", "12345678");
  REQUIRE(list.call("bag", folder.path() / "drive.bag", "bz2"));
  const fs::path bag = folder.path() / "drive.bag";
  CHECK(Played(bag).message ==
        "the bag has several cameras; set left to one of: /front/image/compressed, /rear/image");
  CHECK(Played(bag, {{"left", std::string("/side")}}).message ==
        "the bag has no topic /side; set left to one of: /front/image/compressed, /rear/image");
  const Played played(bag, {{"left", std::string("/front/image/compressed")}});
  REQUIRE(played.frames.size() == pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    CHECK(cv::norm(asMat(played.frames[i].left), pictures[i], cv::NORM_INF) == 0);
    CHECK(played.frames[i].stamp_ns == stampOf(static_cast<int>(i)));
  }
}

TEST_CASE("a recording of ROS 1 that was killed is used as far as it goes", "[optional]") {
  if (!test::ros1OrSkip()) return;
  const test::TemporaryFolder folder;
  test::Ros1List list(folder.path());
  for (int i = 0; i < 40; ++i) {
    list.image("/camera", stampOf(i), 8, 6, "mono8", std::string(48, static_cast<char>(i)));
  }
  const fs::path bag = folder.path() / "killed.bag";
  REQUIRE(list.call("bag", bag, "none unclosed"));
  const Played played(bag);
  CHECK(played.message.empty());
  REQUIRE(played.findings().size() == 1);
  CHECK_THAT(played.findings()[0], Catch::Contains("cut off"));
  CHECK(played.frames.size() >= 20);  // the chunk that was open is not in the file
  for (std::size_t i = 0; i < played.frames.size(); ++i) {
    CHECK(played.frames[i].stamp_ns == stampOf(static_cast<int>(i)));
    CHECK(played.frames[i].left.row(5)[7] == i);
  }
}

}  // namespace tolman::ros_bag
