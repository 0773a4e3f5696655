// SPDX-License-Identifier: BSD-3-Clause
#include "map_messages.hpp"

#include <catch2/catch.hpp>

#include "messages.hpp"
#include "support/ros_bag_writer.hpp"

namespace tolman::ros_map {
namespace {

std::string textOf(const FieldWriter& writer) {
  return {writer.message().begin(), writer.message().end()};
}

}  // namespace

TEST_CASE("fields are aligned in ROS 2, and packed in ROS 1") {
  FieldWriter ros2;
  ros2.number(std::uint8_t{7}).number(1.5).text("ab").number(std::uint16_t{1}).bytes("xyz");
  const test::CdrWriter other = test::CdrWriter()
                                    .number(std::uint8_t{7})
                                    .number(1.5)
                                    .text("ab")
                                    .number(std::uint16_t{1})
                                    .data("xyz");
  CHECK(textOf(ros2) == other.bytes());
  FieldWriter ros1(Format::Ros1);
  ros1.number(std::uint8_t{7}).number(1.5).text("ab").header(5'000'000'006, "c");
  CHECK(ros1.message().size() == 1 + 8 + 4 + 2 + 4 + 8 + 4 + 1);
}

TEST_CASE("our decoder reads odometry, poses and transforms back") {
  RosPose pose{{1, 2, 3}, 0, 0, 0.6, 0.8};
  for (const auto& [format, encoding] : {std::pair(Format::Ros2, ros_messages::Encoding::Cdr),
                                         std::pair(Format::Ros1, ros_messages::Encoding::Ros1)}) {
    FieldWriter odometry(format);
    writeOdometry(odometry, 1'234'567'890'123, {"odom", "camera", pose}, {1, 2, 3, 4, 5, 6});
    const auto read = ros_messages::readOdometry({odometry.message(), encoding});
    REQUIRE(read);
    CHECK(read->stamp_ns == 1'234'567'890'123);
    CHECK(read->frame == "odom");
    CHECK(read->child_frame == "camera");
    CHECK(read->position == std::array<double, 3>{1, 2, 3});
    CHECK(read->orientation == std::array<double, 4>{0, 0, 0.6, 0.8});
    CHECK(read->velocity == std::array<double, 3>{1, 2, 3});
    FieldWriter transforms(format);
    writeTransforms(transforms, 5, {{"map", "odom", {}}, {"odom", "camera", pose}});
    const auto poses =
        ros_messages::readPoses("tf2_msgs/msg/TFMessage", {transforms.message(), encoding});
    REQUIRE(poses);
    REQUIRE(poses->size() == 2);
    CHECK(poses->back().child_frame == "camera");
    CHECK(poses->back().position == std::array<double, 3>{1, 2, 3});
  }
}

}  // namespace tolman::ros_map
