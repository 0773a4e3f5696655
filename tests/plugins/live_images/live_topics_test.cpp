// SPDX-License-Identifier: BSD-3-Clause
#include "live_topics.hpp"

#include <catch2/catch.hpp>

namespace tolman::live_images {
namespace {

using Published = std::map<std::string, std::string>;

constexpr const char* kImage = "sensor_msgs/Image";
constexpr const char* kCompressed = "sensor_msgs/CompressedImage";
constexpr const char* kInfo = "sensor_msgs/CameraInfo";

std::string chosen(const Published& published, const LiveParameters& parameters = {}) {
  const auto topics = chooseLiveTopics(published, parameters, "rostopic");
  if (!topics.isOk()) return topics.status().message();
  const LiveTopics& t = topics.value();
  return t.left + " " + t.right + " " + t.left_info + " " + t.right_info;
}

const Published kPair = {{"/left/image_raw", kImage},   {"/left/image_raw/compressed", kCompressed},
                         {"/left/camera_info", kInfo},  {"/right/image_raw", kImage},
                         {"/right/camera_info", kInfo}, {"/rosout", "rosgraph_msgs/Log"}};

}  // namespace

TEST_CASE("types are named as ROS 2 names them") {
  CHECK(ros2Type("sensor_msgs/Image") == "sensor_msgs/msg/Image");
  CHECK(ros2Type("sensor_msgs/msg/Image") == "sensor_msgs/msg/Image");
  CHECK(ros2Type("odd") == "odd");
}

TEST_CASE("the only camera, or the only pair") {
  CHECK(chosen({{"/cam", kImage}}) == "/cam   ");
  CHECK(chosen({{"/c/image", kCompressed}, {"/c/camera_info", kInfo}}) ==
        "/c/image  /c/camera_info ");
  CHECK(chosen(kPair) == "/left/image_raw /right/image_raw /left/camera_info /right/camera_info");
  LiveParameters mono;
  mono.mono = true;
  mono.left = "/right/image_raw";
  CHECK(chosen(kPair, mono) == "/right/image_raw  /right/camera_info ");
}

TEST_CASE("topics that may yet come are invalid input, a choice is one of parameters") {
  const auto code = [](const Published& published, const LiveParameters& parameters) {
    return chooseLiveTopics(published, parameters, "rostopic").status().code();
  };
  CHECK(code({}, {}) == StatusCode::InvalidInput);
  CHECK(chosen({{"/rosout", "rosgraph_msgs/Log"}}) ==
        "nobody publishes images; start the camera's node (`rostopic list` shows the topics)");
  const Published two = {{"/front", kImage}, {"/rear", kImage}};
  CHECK(code(two, {}) == StatusCode::InvalidParameter);
  CHECK(chosen(two) == "there are several cameras; set left to one of: /front, /rear");
  LiveParameters named;
  named.left = "/top";
  CHECK(code(two, named) == StatusCode::InvalidInput);
  CHECK(chosen(two, named) == "nobody publishes /top; topics with images are: /front, /rear");
  named.left = "/rosout";
  CHECK(chosen(kPair, named) == "topic /rosout is of type rosgraph_msgs/Log; name another one");
}

TEST_CASE("a pair needs a calibration") {
  Published without = kPair;
  without.erase("/right/camera_info");
  CHECK(chosen(without) ==
        "nobody publishes a CameraInfo beside /left/image_raw and /right/image_raw; set left_info "
        "and right_info, give pinhole and baseline, or set mono: true");
  LiveParameters given;
  given.right_info = "/left/camera_info";
  CHECK(chosen(without, given) ==
        "/left/image_raw /right/image_raw /left/camera_info /left/camera_info");
  given.right_info = "/left/image_raw";
  CHECK(chosen(without, given).find("is of type sensor_msgs/Image") != std::string::npos);
  given = {};
  given.pinhole = {500};
  CHECK(chosen(without, given) == "/left/image_raw /right/image_raw  ");
}

TEST_CASE("depth and measurements are those that are named, and no cameras") {
  const Published robot = {{"/rgb", kImage},
                           {"/depth", kImage},
                           {"/imu", "sensor_msgs/msg/Imu"},
                           {"/odom", "nav_msgs/msg/Odometry"}};
  LiveParameters named;
  named.depth = "/depth";
  named.imu = "/imu";
  named.odometry = "/odom";
  CHECK(chosen(robot, named) == "/rgb   ");
  named.odometry = "/imu";
  CHECK(chosen(robot, named) == "topic /imu is of type sensor_msgs/msg/Imu; name another one");
}

}  // namespace tolman::live_images
