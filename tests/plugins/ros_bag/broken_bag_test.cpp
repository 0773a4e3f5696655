// SPDX-License-Identifier: BSD-3-Clause
// Bags that are damaged or truncated, and other files: one clear error each.
#include <catch2/catch.hpp>

#include "bag_case.hpp"
#include "ros1_case.hpp"

namespace tolman::ros_bag {
namespace {

std::string withoutFolder(std::string text, const test::TemporaryFolder& folder) {
  const std::string name = folder.path().string() + "/";
  for (auto at = text.find(name); at != std::string::npos; at = text.find(name)) {
    text.erase(at, name.size());
  }
  return text;
}

const ParameterValues kSkip = {{"on_corrupt", std::string("skip")}};

}  // namespace

TEST_CASE("what is no bag") {
  const test::TemporaryFolder folder;
  const auto message = [&](const std::string& bytes) {
    test::writeBytes(folder.path() / "a.bag", bytes);
    return withoutFolder(Played(folder.path() / "a.bag").message, folder);
  };
  CHECK(message("text") == "a.bag: is no bag of ROS (.mcap, .db3 or .bag); check the path");
  CHECK(message("#ROSBAG V2.0\n") ==
        "a.bag: ends within the record at byte 13: the recording was cut off; use what is there by "
        "on_corrupt: skip");
  CHECK(message("SQLite format 3").find("is no bag of ROS") != std::string::npos);
  CHECK(withoutFolder(Played(folder.path() / "none").message, folder) ==
        "none: not a readable file; check the path");
  CHECK(message(test::mcapBytes({greyImage("/a", 0)}, {"", true, 3, true, "json"})) ==
        "the bag has no images; `tolman dataset check` lists its topics");
}

TEST_CASE("a recording that was killed stops the run, or is used as far as it goes") {
  const test::TemporaryFolder folder;
  std::string bytes = test::mcapBytes(pairMessages(9), {"zstd", true, 4});
  bytes.resize(bytes.size() * 3 / 4);
  test::writeBytes(folder.path() / "a.mcap", bytes);
  Played stopped(folder.path() / "a.mcap");
  CHECK(stopped.message.find("the recording was cut off") != std::string::npos);
  CHECK(stopped.findings().back().find("error : ") == 0);
  Played skipped(folder.path() / "a.mcap", kSkip);
  CHECK(skipped.message.empty());
  CHECK(skipped.frames.size() >= 4);
  REQUIRE(skipped.context.log.size() == 1);
  CHECK(skipped.context.log[0].find("the recording was cut off") != std::string::npos);
  CHECK(skipped.context.log[0].ends_with("; what is damaged is left out"));
  CHECK(skipped.context.log[0].find("on_corrupt") == std::string::npos);  // it is chosen
  for (const std::string& finding : skipped.findings()) {
    CHECK(finding.find("on_corrupt") == std::string::npos);
  }
}

TEST_CASE("a bag of a camera of 10 bits is told of, with the bits to set") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 11; ++i) {
    std::string pixels;
    for (int p = 0; p < 48; ++p) pixels += std::string("\xfe\x03", 2);
    messages.push_back({"/camera", std::string(kImage), stampOf(i),
                        test::imageMessage({stampOf(i), 8, 6, "mono16", pixels})});
  }
  test::writeDb3(folder.path() / "a.db3", messages);
  const Played played(folder.path() / "a.db3");
  CHECK(played.frames.size() == 11);
  REQUIRE(played.context.log.size() == 1);
  CHECK(played.context.log[0].find("/camera: the values of the first 10 images of 16 bits stay "
                                   "below 1024") != std::string::npos);
  const Played right(folder.path() / "a.db3", {{"bits", std::int64_t{10}}});
  CHECK(right.context.log.empty());
  CHECK(right.frames[0].left.row(0)[0] == 255);
  const Played low(folder.path() / "a.db3", {{"bits", std::int64_t{9}}});
  REQUIRE(low.context.log.size() == 1);
  CHECK(low.context.log[0].find("has values of more than 9 bits") != std::string::npos);
}

/// 12 bits (4000) in messages of 16, with one white pixel; little endian.
std::string pixelsWithHotOne() {
  std::string pixels;
  for (int p = 0; p < 160 * 120; ++p) pixels += std::string("\xa0\x0f", 2);
  return pixels.replace(pixels.size() / 2, 2, "\xff\xff");
}

void checkTwelveBits(const std::filesystem::path& bag) {
  const Played played(bag);
  CHECK(played.frames.size() == 11);
  REQUIRE(played.context.log.size() == 1);
  CHECK(played.context.log[0].find("/camera: nearly all values of the first 10 images of 16 bits "
                                   "stay below 4096, so that hardly any grey level is above 15 of "
                                   "255; set source.bits=12 ") != std::string::npos);
}

TEST_CASE("a hot pixel does not hide in a ROS 2 bag that the camera has 12 bits") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 11; ++i) {
    messages.push_back({"/camera", std::string(kImage), stampOf(i),
                        test::imageMessage({stampOf(i), 160, 120, "mono16", pixelsWithHotOne()})});
  }
  test::writeDb3(folder.path() / "a.db3", messages);
  checkTwelveBits(folder.path() / "a.db3");
  test::writeBytes(folder.path() / "a.mcap", test::mcapBytes(messages));
  checkTwelveBits(folder.path() / "a.mcap");
}

TEST_CASE("nor in a ROS 1 bag") {
  const test::TemporaryFolder folder;
  std::string bag = ros1Connection(0, "/camera", "sensor_msgs/Image");
  for (std::uint32_t i = 0; i < 11; ++i) {
    bag += ros1Message(0, i + 1,
                       rawNumber(i) + rawNumber(i + 1) + rawNumber(0U) + ros1Text("camera") +
                           rawNumber(120U) + rawNumber(160U) + ros1Text("mono16") + '\0' +
                           rawNumber(320U) + ros1Text(pixelsWithHotOne()));
  }
  const std::string start = ros1Start(1);
  test::writeBytes(folder.path() / "a.bag",
                   ros1Start(static_cast<std::uint64_t>(start.size() + bag.size())) + bag);
  checkTwelveBits(folder.path() / "a.bag");
}

TEST_CASE("a damaged image in a sound bag") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 4; ++i) messages.push_back(greyImage("/camera", i));
  messages[2].bytes = test::imageMessage({stampOf(2), 8, 6, "mono8", std::string(42, 'x')});
  test::writeDb3(folder.path() / "a.db3", messages);
  const Played stopped(folder.path() / "a.db3");
  CHECK(stopped.frames.size() == 2);
  CHECK(withoutFolder(stopped.message, folder) ==
        "a.db3: image 2 of /camera (stamp " + std::to_string(stampOf(2)) +
            " ns) has rows of 7 bytes instead of 8; record it again, or leave it out by "
            "on_corrupt: skip");
  const Played skipped(folder.path() / "a.db3", kSkip);
  CHECK(skipped.message.empty());
  REQUIRE(skipped.frames.size() == 4);
  CHECK(skipped.frames[2].left.empty());
  CHECK_FALSE(skipped.frames[2].defect.empty());
  CHECK_FALSE(skipped.frames[3].left.empty());
}

TEST_CASE("images with the same time and other contents are refused") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages = {greyImage("/camera", 0), greyImage("/camera", 1),
                                            greyImage("/camera", 1)};
  messages[2].bytes = test::imageMessage({stampOf(1), 8, 6, "mono8", std::string(48, 'x')});
  test::writeDb3(folder.path() / "a.db3", messages);
  const std::string text = "/camera: messages 1 and 2 (counted from 0) have the time " +
                           std::to_string(stampOf(1)) + " ns in their headers and different images";
  CHECK(Played(folder.path()).message == text + "; leave them out by on_corrupt: skip");
  const Played skipped(folder.path(), kSkip);
  CHECK(skipped.message.empty());
  CHECK(skipped.frames.size() == 2);
  CHECK_THAT(skipped.context.log.at(0), Catch::Contains(text));
}

TEST_CASE("an image that was recorded twice is used once, and told") {
  const test::TemporaryFolder folder;
  const std::vector<test::RosMessage> messages = {greyImage("/camera", 0), greyImage("/camera", 1),
                                                  greyImage("/camera", 1), greyImage("/camera", 2)};
  test::writeDb3(folder.path() / "a.db3", messages);
  test::writeBytes(folder.path() / "a.mcap", test::mcapBytes(messages, {"zstd"}));
  for (const char* name : {"a.db3", "a.mcap"}) {
    CAPTURE(name);
    const Played played(folder.path() / name);
    CHECK(played.message.empty());
    CHECK(played.frames.size() == 3);
    CHECK_THAT(played.context.log.at(0),
               Catch::EndsWith("/camera: 1 message is recorded twice, with the same time and the "
                               "same bytes; each is used once"));
  }
}

}  // namespace tolman::ros_bag
