// SPDX-License-Identifier: BSD-3-Clause
// Inertial measurements, odometry and depth beside the images.
#include <catch2/catch.hpp>

#include "bag_case.hpp"

namespace tolman::ros_bag {
namespace {

const NamedArray& sensor(const Frame& frame, const std::string& name) {
  for (const NamedArray& array : frame.sensors) {
    if (array.name == name) return array;
  }
  FAIL("no sensor " << name);
  return frame.sensors.front();
}

std::vector<test::RosMessage> drive() {
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 4; ++i) messages.push_back(greyImage("/camera/image", i));
  for (int i = 0; i < 40; ++i) {  // ten between two images, at 5 ms after the first and so on
    const std::int64_t stamp = stampOf(0) + 5'000'000LL * (i + 1);
    messages.push_back({"/imu", std::string(kImu), stamp,
                        test::imuMessage(stamp, {0.1, 0.2, i + 0.0}, {1, 2, 9.5})});
  }
  for (int i = 0; i < 3; ++i) {  // 1 m forward in 100 ms, then a quarter turn to the left
    const std::int64_t stamp = stampOf(2 * i) - 50'000'000;
    messages.push_back(
        {"/odom", std::string(kOdometry), stamp,
         test::odometryMessage(stamp, 1.0 * std::min(i, 1), 0, i == 2 ? M_PI_2 : 0)});
  }
  return messages;
}

}  // namespace

TEST_CASE("means of inertial measurements, and motion between the images") {
  const test::TemporaryFolder folder;
  test::writeBytes(folder.path() / "bag.mcap", test::mcapBytes(drive(), {"lz4"}));
  Played played(folder.path());
  CHECK(played.message.empty());
  REQUIRE(played.frames.size() == 4);
  CHECK(sensor(played.frames[0], "imu.samples").values[0] == 0);
  CHECK(sensor(played.frames[2], "imu.samples").values[0] == 10);
  const auto& turning = sensor(played.frames[2], "imu.angular_velocity").values;
  CHECK(turning[1] == 0.2F);
  CHECK(turning[2] == Approx(14.5));  // mean of 10 ... 19
  CHECK(sensor(played.frames[3], "imu.linear_acceleration").values[2] == 9.5F);
  // Measured 50 ms before images 0, 2 and 4: at image 1 the drive is over, at image 2 half turned.
  CHECK(sensor(played.frames[0], "motion.planar").values == std::vector<float>{0, 0, 0});
  CHECK(sensor(played.frames[1], "motion.planar").values[0] == Approx(0.5));
  const auto& turn = sensor(played.frames[2], "motion.planar").values;
  CHECK(turn[0] == Approx(0).margin(1e-6));
  CHECK(turn[2] == Approx(M_PI / 4));
  std::vector<ArrayInfo> arrays;
  REQUIRE(played.source.describe(arrays).isOk());
  CHECK(arrays.size() == played.frames[0].sensors.size());
}

TEST_CASE("depth goes along, 0 where there is none") {
  std::vector<test::RosMessage> messages = {greyImage("/rgb", 0), greyImage("/rgb", 1)};
  std::string pixels;
  for (int i = 0; i < 48; ++i) pixels += std::string("\xdc\x05", 2);  // 1500 mm
  messages.push_back({"/depth", std::string(kImage), stampOf(1),
                      test::imageMessage({stampOf(1) + 2'000'000, 8, 6, "16UC1", pixels})});
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "bag.db3", messages);
  Played played(folder.path(), {{"depth", std::string("/depth")}});
  CHECK(played.message.empty());
  REQUIRE(played.frames.size() == 2);
  CHECK(sensor(played.frames[0], "depth").shape == std::vector<int>{6, 8});
  CHECK(sensor(played.frames[0], "depth").values == std::vector<float>(48, 0));
  CHECK(sensor(played.frames[1], "depth").values == std::vector<float>(48, 1.5F));
  std::vector<ArrayInfo> arrays;
  REQUIRE(played.source.describe(arrays).isOk());
  CHECK(arrays.at(0).kind == ArrayKind::DepthImage);
  CHECK(played.findings() ==
        std::vector<std::string>{
            "warning /depth: has no image within the tolerance for 1 of 2 frames"});
}

TEST_CASE("depth of another size than the images is reported") {
  std::vector<test::RosMessage> messages = {greyImage("/rgb", 0)};
  messages.push_back({"/depth", std::string(kImage), stampOf(0),
                      test::imageMessage({stampOf(0), 4, 3, "16UC1", std::string(24, '\1')})});
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "bag.db3", messages);
  Played played(folder.path(), {{"depth", std::string("/depth")}});
  CHECK(played.message.empty());
  CHECK(played.findings() ==
        std::vector<std::string>{"warning /depth: has images of 4x3 px, and the camera of 8x6 px"});
}

}  // namespace tolman::ros_bag
