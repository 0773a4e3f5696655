// SPDX-License-Identifier: BSD-3-Clause
// Messages that are empty, end within their header, or have a time before 1970: named as such, in
// bags of ROS 2 (SQLite, MCAP) and ROS 1.
#include <algorithm>
#include <catch2/catch.hpp>

#include "ros1_case.hpp"

namespace tolman::ros_bag {
namespace {

const ParameterValues kSkipped = {{"on_corrupt", std::string("skip")}};

/// Five images of one camera; number `which` is replaced.
std::vector<test::RosMessage> fiveImages(std::size_t which, const std::string& bytes) {
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 5; ++i) messages.push_back(greyImage("/camera", i));
  messages[which].bytes = bytes;
  return messages;
}

std::string imageAt(std::int64_t stamp_ns) {
  return test::imageMessage({stamp_ns, 8, 6, "mono8", std::string(48, 'x')});
}

std::string recordedAt(int index) {
  return "(recorded at " + std::to_string(stampOf(index) + 3'000'000) + " ns)";
}

std::string ros1Image(std::uint32_t seconds) {
  return rawNumber(std::uint32_t{0}) + rawNumber(seconds) + rawNumber(std::uint32_t{0}) +
         ros1Text("camera") + rawNumber(std::uint32_t{6}) + rawNumber(std::uint32_t{8}) +
         ros1Text("mono8") + '\0' + rawNumber(std::uint32_t{8}) + ros1Text(std::string(48, 'x'));
}

}  // namespace

TEST_CASE("an empty message is named, not taken for an image without a time") {
  const test::TemporaryFolder folder;
  const auto messages = fiveImages(2, "");
  test::writeDb3(folder.path() / "a.db3", messages);
  test::writeBytes(folder.path() / "a.mcap", test::mcapBytes(messages, {"zstd"}));
  const std::string text = "/camera: message 2 " + recordedAt(2) + " is empty";
  for (const char* name : {"a.db3", "a.mcap"}) {
    CAPTURE(name);
    Played stopped(folder.path() / name);
    CHECK(stopped.message == text + "; leave them out by on_corrupt: skip");
    CHECK(std::ranges::count(stopped.findings(),
                             "error : " + text + "; leave them out by on_corrupt: skip") == 1);
    Played skipped(folder.path() / name, kSkipped);
    CHECK(skipped.message.empty());
    CHECK(skipped.frames.size() == 4);
    CHECK(skipped.context.log.size() == 1);
    CHECK(std::ranges::any_of(skipped.findings(), [&](const std::string& finding) {
      return finding.starts_with("warning : " + text);
    }));
  }
}

TEST_CASE("an empty message of a bag of ROS 1") {
  const test::TemporaryFolder folder;
  std::string records = ros1Connection(0, "/camera", "sensor_msgs/Image");
  for (std::uint32_t i = 1; i <= 4; ++i) {
    records += ros1Message(0, 100 + i, i == 2 || i == 3 ? "" : ros1Image(100 + i));
  }
  const std::string chunk = ros1Chunk(records);
  test::writeBytes(folder.path() / "a.bag", ros1Start(ros1Start(0).size() + chunk.size()) + chunk);
  CHECK_THAT(
      Played(folder.path() / "a.bag", kSkipped).context.log.at(0),
      Catch::Contains("/camera: message 1 (recorded at 102000000007 ns) is empty, and 1 more "
                      "like it"));
}

TEST_CASE("images without any time in their headers have those of recording, with a warning") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages = fiveImages(0, imageAt(0));
  for (test::RosMessage& message : messages) message.bytes = imageAt(0);
  test::writeDb3(folder.path() / "a.db3", messages);
  const Played played(folder.path() / "a.db3");
  CHECK(played.message.empty());
  REQUIRE(played.frames.size() == 5);
  CHECK(played.frames[1].stamp_ns == stampOf(1) + 3'000'000);
  REQUIRE(played.context.log.size() == 1);
  CHECK_THAT(played.context.log[0],
             Catch::EndsWith("/camera: no message has a time in its header; the times of "
                             "recording are used, which are later than those of the measurements"));
}

TEST_CASE("a message that ends within its header, and the first of its topic") {
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "a.db3", fiveImages(0, imageAt(stampOf(0)).substr(0, 10)));
  CHECK(Played(folder.path() / "a.db3").message ==
        "/camera: message 0 " + recordedAt(0) +
            " ends within its header; leave them out by on_corrupt: skip");
  const Played skipped(folder.path() / "a.db3", kSkipped);
  CHECK(skipped.message.empty());
  CHECK(skipped.frames.size() == 4);
}

TEST_CASE("an image with more bytes than its header says is damaged") {
  const test::TemporaryFolder folder;
  const std::string longer = test::imageMessage({stampOf(2), 8, 6, "mono8", std::string(49, 'x')});
  test::writeDb3(folder.path() / "a.db3", fiveImages(2, longer));
  CHECK_THAT(Played(folder.path() / "a.db3").message,
             Catch::Contains("has 49 bytes of pixels instead of 48"));
}

TEST_CASE("rows three times as long as the encoding needs are doubted") {
  const test::TemporaryFolder folder;
  const std::string colour =
      test::imageMessage({stampOf(0), 8, 6, "mono8", std::string(3 * 48, 'x')});
  test::writeDb3(folder.path() / "a.db3", fiveImages(0, colour));
  Played played(folder.path() / "a.db3");
  CHECK(played.frames.size() == 5);
  const std::string text =
      "/camera: the first image has rows of 24 bytes, 3 times those of 8 px in the encoding "
      "'mono8': are the encoding and the width right?";
  REQUIRE(played.context.log.size() == 1);
  CHECK_THAT(played.context.log[0], Catch::EndsWith(text));
  CHECK(std::ranges::count(played.findings(), "warning : " + text) == 1);
}

TEST_CASE("a header with nanoseconds that no clock gives is damaged") {
  const test::TemporaryFolder folder;
  std::string bytes = imageAt(stampOf(2));
  bytes[11] = static_cast<char>(bytes[11] | 0x40);  // bit 30 of the nanoseconds
  test::writeDb3(folder.path() / "a.db3", fiveImages(2, bytes));
  CHECK(Played(folder.path() / "a.db3").message ==
        "/camera: message 2 " + recordedAt(2) +
            " has a damaged header; leave them out by on_corrupt: skip");
  CHECK(Played(folder.path() / "a.db3", kSkipped).frames.size() == 4);
}

TEST_CASE("a time that moves an image to another place is told") {
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "a.db3", fiveImages(1, imageAt(stampOf(3) + 1)));
  Played moved(folder.path() / "a.db3");
  CHECK(moved.frames.size() == 5);
  CHECK_THAT(moved.context.log.at(0),
             Catch::Contains("/camera: by the times in their headers, 2 messages lie before one "
                             "that was recorded earlier, the first of them message 2 (counted "
                             "from 0)"));
  test::writeDb3(folder.path() / "b.db3", fiveImages(1, imageAt(stampOf(1))));
  CHECK(Played(folder.path() / "b.db3").context.log.empty());
}

TEST_CASE("a bag whose images are all empty is refused, also with on_corrupt: skip") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages = pairMessages(3);
  for (test::RosMessage& message : messages) {
    if (message.topic == "/right/image_rect") message.bytes.clear();
  }
  test::writeDb3(folder.path() / "a.db3", messages);
  CHECK_THAT(Played(folder.path() / "a.db3", kSkipped).message,
             Catch::Contains("/right/image_rect: message 0") &&
                 Catch::Contains(" is empty, and so is every other; record it again"));
  test::writeDb3(folder.path() / "b.db3", {{"/camera", std::string(kImage), stampOf(0), ""}});
  CHECK_THAT(Played(folder.path() / "b.db3", kSkipped).message,
             Catch::Contains("/camera: message 0") && Catch::Contains("every other"));
}

TEST_CASE("times before 1970 are told, and never silently replaced") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> all;
  for (int i = 0; i < 4; ++i) {
    all.push_back(greyImage("/camera", i));
    all.back().bytes = imageAt(-5'000'000'000 + std::int64_t{i} * 1'000'000'000);
  }
  test::writeDb3(folder.path() / "all.db3", all);
  const std::string text =
      "/camera: message 0 " + recordedAt(0) +
      " has the time -5000000000 ns in its header, before 1970, and 3 more like "
      "it: its clock was wrong";
  CHECK(Played(folder.path() / "all.db3").message == text + "; leave them out by on_corrupt: skip");
  Played recorded(folder.path() / "all.db3", kSkipped);
  CHECK(recorded.message.empty());
  REQUIRE(recorded.frames.size() == 4);
  CHECK(recorded.frames[0].stamp_ns == stampOf(0) + 3'000'000);
  CHECK_THAT(recorded.context.log.at(0), Catch::Contains(text));
  test::writeDb3(folder.path() / "one.db3", fiveImages(3, imageAt(-1'000'000'000)));
  CHECK_THAT(Played(folder.path() / "one.db3").message, Catch::Contains("/camera: message 3"));
  CHECK(Played(folder.path() / "one.db3", kSkipped).frames.size() == 4);
}

TEST_CASE("damaged messages of other topics of the run are named, too") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages = pairMessages(3);
  messages.push_back({"/imu", std::string(kImu), stampOf(0), ""});
  messages.push_back(
      {"/imu", std::string(kImu), stampOf(1), test::imuMessage(stampOf(1), {0, 0, 1}, {0, 0, 9})});
  test::writeDb3(folder.path() / "a.db3", messages);
  CHECK_THAT(Played(folder.path() / "a.db3", {{"imu", std::string("/imu")}}).message,
             Catch::Contains("/imu: message 0") && Catch::Contains("is empty"));
  messages.end()[-2].bytes = messages.back().bytes.substr(0, 60);
  test::writeDb3(folder.path() / "b.db3", messages);
  CHECK_THAT(
      Played(folder.path() / "b.db3", {{"imu", std::string("/imu")}}).message,
      Catch::Contains("1 messages of other sensors are damaged, first of /imu with the stamp " +
                      std::to_string(stampOf(1)) + " ns"));
}

TEST_CASE("an empty CameraInfo is not the camera of the topic") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages = pairMessages(3);
  messages.insert(messages.begin(),
                  {"/left/camera_info", std::string(kCameraInfo), stampOf(0) - 1, ""});
  test::writeDb3(folder.path() / "a.db3", messages);
  CHECK_THAT(Played(folder.path() / "a.db3").message,
             Catch::Contains("/left/camera_info: message 0") && Catch::Contains("is empty"));
  const Played skipped(folder.path() / "a.db3", kSkipped);
  CHECK(skipped.message.empty());
  CHECK(skipped.info.rig.calibrated);
}

}  // namespace tolman::ros_bag
