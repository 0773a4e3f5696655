// SPDX-License-Identifier: BSD-3-Clause
// One recording in both formats, written by another program (rosbags 0.10). The numbers were read
// from the files with Python's sqlite3 and struct alone.
#include <catch2/catch.hpp>

#include "bag_case.hpp"

namespace tolman::ros_bag {
namespace {

/// Never asked to stop.
struct Running : Cancellation {
  bool requested() const override { return false; }
};

struct Findings : FindingCollector {
  void add(Finding finding) override { all.push_back(std::move(finding)); }
  std::vector<Finding> all;
};

Bag openBag(const std::filesystem::path& path) {
  Findings findings;
  auto bag = Bag::open(path, Running(), findings);
  REQUIRE(bag.isOk());
  CHECK(findings.all.empty());
  return std::move(bag).value();
}

}  // namespace

TEST_CASE("both formats have the same topics, messages and pixels", "[data]") {
  const auto data = test::dataOrSkip("ros2_bags");
  if (!data) return;
  Bag mcap = openBag(*data / "test_bag_mcap");
  Bag sqlite = openBag(*data / "test_bag_sqlite3");
  CHECK(mcap.topics().size() == 94);
  CHECK(sqlite.topics().size() == 94);
  int compared = 0;
  for (const auto& [name, topic] : mcap.topics()) {
    const auto other = sqlite.topics().find(name);
    REQUIRE(other != sqlite.topics().end());
    CHECK(other->second.topic.type == topic.topic.type);
    CHECK(other->second.messages == 2);
    CHECK(topic.messages == 2);
    CHECK(other->second.bytes == topic.bytes);
    for (std::size_t i = 0; i < topic.index.size(); ++i) {
      const auto a = mcap.read(topic.index[i]);
      const auto b = sqlite.read(other->second.index[i]);
      REQUIRE((a.isOk() && b.isOk()));
      // The recordings were made one after the other: all but the stamps, 8 bytes after 4, agrees;
      // those of tf follow a count.
      const int from = isTransforms(topic.topic.type) ? 16 : 12;
      CHECK(std::equal(a.value().begin() + from, a.value().end(), b.value().begin() + from,
                       b.value().end()));
      ++compared;
    }
  }
  CHECK(compared == 18);  // two of each type that is read
}

TEST_CASE("values and stamps of a real bag", "[data]") {
  const auto data = test::dataOrSkip("ros2_bags");
  if (!data) return;
  for (const auto& [name, stamp, log] :
       {std::tuple{"test_bag_sqlite3", 1749315324726751232, 1749315328675930112},
        std::tuple{"test_bag_mcap", 1749315324951608064, 1749315328903302144}}) {
    const Bag bag = openBag(*data / name);
    const auto topic = [&](const char* short_name) {
      return bag.topics().at("/test/" + std::string(short_name));
    };
    CHECK(topic("sensor_msgs/image").index[0].stamp_ns == stamp);
    CHECK(topic("sensor_msgs/image").first_ns == log);
    const auto info = readCameraInfo(topic("sensor_msgs/camera_info").first);
    REQUIRE(info);
    CHECK(info->width == 640);
    CHECK(info->height == 480);
    CHECK(info->model == "plumb_bob");
    CHECK(info->D == std::vector<double>{0.1, -0.2, 0.001, 0.002, 0});
    CHECK(info->K == std::array<double, 9>{525, 0, 320, 0, 525, 240, 0, 0, 1});
    CHECK(info->P == std::array<double, 12>{525, 0, 320, 0, 0, 525, 240, 0, 0, 0, 1, 0});
    const auto imu = readImu(topic("sensor_msgs/imu").first);
    REQUIRE(imu);
    CHECK(imu->angular_velocity == std::array<double, 3>{0.01, 0.02, 0.03});
    CHECK(imu->linear_acceleration == std::array<double, 3>{0.1, 0.2, 9.8});
    const auto odometry = readOdometry(topic("nav_msgs/odometry").first);
    REQUIRE(odometry);
    CHECK(odometry->position == std::array<double, 3>{1, 2, 0});
  }
}

TEST_CASE("images of the real bag lack nearly all pixels, and are left out", "[data]") {
  const auto data = test::dataOrSkip("ros2_bags");
  if (!data) return;
  const auto bag = *data / "test_bag_mcap";
  CHECK(Played(bag).message ==
        "the bag has several cameras; set left to one of: /test/sensor_msgs/compressed_image, "
        "/test/sensor_msgs/image");
  const Played played(bag, {{"left", std::string("/test/sensor_msgs/image")}});
  CHECK(played.frames.size() == 2);
  CHECK_THAT(played.frames.at(0).defect,
             Catch::Contains("has 30 bytes of pixels instead of 921600"));
}

}  // namespace tolman::ros_bag
