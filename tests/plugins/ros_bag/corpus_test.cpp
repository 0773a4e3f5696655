// SPDX-License-Identifier: BSD-3-Clause
// Writes the corpus of the fuzz targets bag_* into the folder TOLMAN_CORPUS. To be run by hand when
// the formats or the tests' writer change: source_ros_bag_test "[corpus]".
#include <catch2/catch.hpp>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>

#include "bag_case.hpp"
#include "ros1_case.hpp"
#include "support/ros1_tool.hpp"

namespace tolman::ros_bag {
namespace {

void writeMessages(const std::filesystem::path& folder) {
  const auto write = [&](const char* name, const std::string& bytes) {
    test::writeBytes(folder / name, bytes);
  };
  for (const char* encoding :
       {"mono8", "rgb8", "bgra8", "mono16", "bayer_rggb8", "yuv422", "16UC1", "32FC1"}) {
    write(encoding, test::imageMessage({5, 4, 4, encoding, std::string(64, 'p')}));
  }
  write("big_endian", test::imageMessage({5, 2, 2, "mono8", "abcd"}, true));
  const cv::Mat picture(8, 8, CV_8UC1, cv::Scalar(90));
  for (const char* type : {".png", ".jpg"}) {
    std::vector<std::uint8_t> coded;
    cv::imencode(type, picture, coded);
    write(type + 1, test::compressedImageMessage(5, type + 1, {coded.begin(), coded.end()}));
  }
  test::RosCamera camera = test::plainCamera(640, 480, 500, 0.2);
  write("camera_info", test::cameraInfoMessage(camera));
  camera.D = {0.1, 0.2, 0.01, 0.02};
  camera.model = "equidistant";
  write("fisheye", test::cameraInfoMessage(camera));
  write("imu", test::imuMessage(5, {1, 2, 3}, {4, 5, 6}));
  write("odometry", test::odometryMessage(5, 1, 2, 3));
}

/// Bags and messages that ROS 1's own modules write.
void writeRos1(const std::filesystem::path& folder) {
  const test::TemporaryFolder scratch;
  test::Ros1List list(scratch.path());
  const std::vector<double> identity = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<double> K = {500, 0, 320, 0, 500, 240, 0, 0, 1};
  const std::vector<double> P = {500, 0, 320, -60, 0, 500, 240, 0, 0, 0, 1, 0};
  list.image("/cam0/image", 5, 4, 4, "mono8", std::string(16, 'p'));
  list.camera("/cam0/camera_info", 640, 480, "plumb_bob", {0.1, 0.2, 0, 0, 0}, K, identity, P);
  REQUIRE(list.call("bag", folder / "bag_ros1" / "none", "none"));
  list.imu("/imu", 6, {1, 2, 3, 4, 5, 6});
  list.odometry("/odom", 7, 1, 2, 0.5);
  list.compressed("/cam0/image/compressed", 8, "png", folder / "bag_messages" / "png");
  REQUIRE(list.call("raw", folder / "bag_messages"));
  for (const char* how : {"bz2", "lz4", "none unclosed"}) {
    const test::TemporaryFolder bags;
    test::Ros1List texts(bags.path());
    for (int i = 0; i < 4; ++i) texts.text("/a", 1'000'000'000 + i, "hello");
    const std::string name = std::string(how).substr(how == std::string("none unclosed") ? 5 : 0);
    REQUIRE(texts.call("bag", folder / "bag_ros1" / name, how));
  }
  test::writeBytes(folder / "bag_ros1" / "small",
                   ros1Start(0) + ros1Chunk(ros1Connection(0, "/a", "std_msgs/String") +
                                            ros1Message(0, 5, "one")));
}

}  // namespace

TEST_CASE("writes the corpus of the fuzz targets", "[.][corpus][data]") {
  const char* target = std::getenv("TOLMAN_CORPUS");
  REQUIRE(target != nullptr);
  const std::filesystem::path folder = target;
  for (const char* name : {"bag_mcap", "bag_ros1", "bag_sqlite", "bag_messages", "bag_metadata"}) {
    std::filesystem::create_directories(folder / name);
  }
  const auto messages = pairMessages(2);
  int number = 0;
  for (const test::McapStyle& style :
       {test::McapStyle{"", false}, test::McapStyle{"", true, 2, false},
        test::McapStyle{"zstd", true, 3, false}, test::McapStyle{"lz4", true, 3, false},
        test::McapStyle{"zstd"}}) {
    test::writeBytes(folder / "bag_mcap" / std::to_string(number++),
                     test::mcapBytes(messages, style));
  }
  test::writeDb3(folder / "bag_sqlite" / "plain", messages);
  test::writeDb3(folder / "bag_sqlite" / "compressed", messages, true);
  writeMessages(folder / "bag_messages");
  if (test::ros1OrSkip()) writeRos1(folder);
  test::writeBytes(folder / "bag_metadata" / "two",
                   "rosbag2_bagfile_information:\n  version: 9\n  relative_file_paths:\n    - "
                   "a_0.mcap\n    - 'a_1.mcap'\n  compression_format: ''\n");
}

}  // namespace tolman::ros_bag
