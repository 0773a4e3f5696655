// SPDX-License-Identifier: BSD-3-Clause
#include "topic_choice.hpp"

#include <catch2/catch.hpp>

#include "bag_case.hpp"

namespace tolman::ros_bag {
namespace {

using Topics = std::map<std::string, BagTopic>;

void add(Topics& topics, const std::string& name, std::string_view type,
         const std::string& encoding = "mono8") {
  BagTopic& topic = topics[name];
  topic.topic = {name, std::string(type), "cdr"};
  topic.messages = 1;
  topic.index.resize(1);
  const std::string message = test::imageMessage({1, 2, 1, encoding, std::string(8, 'x')});
  topic.first.assign(message.begin(), message.end());
}

std::string chosen(const Topics& topics, const BagParameters& parameters = {}) {
  const auto found = chooseTopics(topics, parameters);
  if (!found.isOk()) return found.status().message();
  const ChosenTopics& c = found.value();
  std::string text;
  for (const BagTopic* topic : {c.left, c.right, c.left_info, c.right_info, c.depth, c.imu}) {
    text += (topic == nullptr ? "-" : topic->topic.name) + " ";
  }
  return text;
}

}  // namespace

TEST_CASE("one camera, a pair, and the same images twice") {
  Topics topics;
  CHECK(chosen(topics) == "the bag has no images; `tolman dataset check` lists its topics");
  add(topics, "/cam0/image_raw", kImage);
  CHECK(chosen(topics) == "/cam0/image_raw - - - - - ");
  add(topics, "/cam0/image_raw/compressed", kCompressedImage);
  add(topics, "/cam0/camera_info", kCameraInfo);
  CHECK(chosen(topics) == "/cam0/image_raw - /cam0/camera_info - - - ");
  add(topics, "/cam1/image_raw", kImage);
  CHECK(chosen(topics) == "/cam0/image_raw /cam1/image_raw /cam0/camera_info - - - ");
  BagParameters mono;
  mono.mono = true;
  CHECK(chosen(topics, mono) == "/cam0/image_raw - /cam0/camera_info - - - ");
  mono.left = "/cam0/image_raw/compressed";
  CHECK(chosen(topics, mono) == "/cam0/image_raw/compressed - /cam0/camera_info - - - ");
}

TEST_CASE("a bag of depth alone is refused as such") {
  Topics topics;
  add(topics, "/camera/depth", kImage, "32FC1");
  CHECK(chosen(topics).starts_with("the bag has images of depth only (/camera/depth); record "));
}

TEST_CASE("depth is no camera, and is taken where it is named") {
  Topics topics;
  add(topics, "/camera/color", kImage);
  add(topics, "/camera/depth", kImage, "16UC1");
  add(topics, "/imu", kImu);
  CHECK(chosen(topics) == "/camera/color - - - - /imu ");
  BagParameters parameters;
  parameters.depth = "/camera/depth";
  CHECK(chosen(topics, parameters) == "/camera/color - - - /camera/depth /imu ");
  add(topics, "/imu2", kImu);
  CHECK(chosen(topics) == "/camera/color - - - - - ");
  const auto undecided = chooseTopics(topics, {}).value().undecided;
  REQUIRE(undecided.size() == 1);
  CHECK(undecided[0].where == "/imu, /imu2");
  CHECK(undecided[0].remedy == "set imu to one of them");
}

TEST_CASE("what is ambiguous or wrong names the parameter and the topics") {
  Topics topics;
  add(topics, "/front/image", kImage);
  add(topics, "/rear/image", kImage);
  add(topics, "/imu", kImu);
  CHECK(chosen(topics) ==
        "the bag has several cameras; set left to one of: /front/image, /rear/image");
  BagParameters parameters;
  parameters.left = "/top/image";
  CHECK(chosen(topics, parameters) ==
        "the bag has no topic /top/image; set left to one of: /front/image, /rear/image");
  parameters.left = "/imu";
  CHECK(chosen(topics, parameters) ==
        "topic /imu is of type sensor_msgs/msg/Imu; set left to one "
        "of: /front/image, /rear/image");
  parameters.left = "/rear/image";
  CHECK(chosen(topics, parameters) == "/rear/image - - - - /imu ");
  parameters.left_info = "/imu";
  CHECK(chosen(topics, parameters) ==
        "topic /imu is of type sensor_msgs/msg/Imu; set left_info to one of: none");
}

}  // namespace tolman::ros_bag
