// SPDX-License-Identifier: BSD-3-Clause
// What the source finds in bags that are damaged or contradict themselves, and what it gives.
#include <catch2/catch.hpp>

#include "bag_case.hpp"

namespace tolman::ros_bag {

TEST_CASE("what is no bag is refused with a remedy") {
  const test::TemporaryFolder folder;
  const std::string name = (folder.path() / "a.bag").string();
  const auto message = [&](const std::string& bytes) {
    test::writeBytes(name, bytes);
    return Played(name).message;
  };
  CHECK(message("text") == name + ": is no bag of ROS (.mcap, .db3 or .bag); check the path");
  CHECK(Played(folder.path() / "none").message ==
        (folder.path() / "none").string() + ": not a readable file; check the path");
  CHECK(message(test::mcapBytes({greyImage("/a", 0)}, {"", true, 3, true, "json"})) ==
        "the bag has no images; `tolman dataset check` lists its topics");
}

TEST_CASE("a recording that was killed is used as far as it goes") {
  const test::TemporaryFolder folder;
  std::string bytes = test::mcapBytes(pairMessages(9), {"zstd", true, 4});
  bytes.resize(bytes.size() * 3 / 4);
  test::writeBytes(folder.path() / "a.mcap", bytes);
  const Played played(folder.path() / "a.mcap");
  CHECK(played.message.empty());
  CHECK(played.frames.size() >= 4);
  REQUIRE(played.findings().size() == 1);
  CHECK(played.context.findings[0].kind == Finding::Kind::Damaged);
  CHECK_THAT(played.findings()[0], Catch::StartsWith("error ") && Catch::Contains("cut off"));
}

TEST_CASE("a damaged image of a bag gives a frame without images") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 4; ++i) messages.push_back(greyImage("/camera", i));
  messages[2].bytes = test::imageMessage({stampOf(2), 8, 6, "mono8", std::string(42, 'x')});
  test::writeDb3(folder.path() / "a.db3", messages);
  const Played played(folder.path() / "a.db3");
  CHECK(played.message.empty());
  REQUIRE(played.frames.size() == 4);
  CHECK(played.frames[2].left.empty());
  CHECK(played.frames[2].defect == "image 2 of /camera has rows of 7 bytes instead of 8");
  CHECK_FALSE(played.frames[3].left.empty());
  CHECK(played.findings() ==
        std::vector<std::string>{"error image 2 of /camera: has rows of 7 bytes instead of 8"});
}

TEST_CASE("images without a time in their header are not mixed with those that have one") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages = pairMessages(6);
  for (std::size_t camera = 0; camera < 2; ++camera) {  // before the simulated clock is published
    messages[2 + camera].bytes = test::imageMessage({0, 8, 6, "mono8", std::string(48, 'x')});
  }
  test::writeDb3(folder.path() / "a.db3", messages);
  const Played played(folder.path() / "a.db3");
  REQUIRE(played.frames.size() == 5);
  CHECK(played.frames[0].stamp_ns == stampOf(1));
  CHECK(played.findings().at(0) ==
        "error /left/image_rect: has 1 messages without a time in their header");
}

TEST_CASE("of images with the same time the first is used") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages = {greyImage("/camera", 0), greyImage("/camera", 1),
                                            greyImage("/camera", 1), greyImage("/camera", 2)};
  test::writeDb3(folder.path() / "a.db3", messages);
  const Played played(folder.path());
  CHECK(played.frames.size() == 3);
  CHECK(played.findings() ==
        std::vector<std::string>{"warning /camera: has 1 messages with the time of another"});
}

TEST_CASE("a camera of 12 bits in messages of 16 is reported with the bits to set") {
  const test::TemporaryFolder folder;
  std::string pixels;  // 4000, with one white pixel
  for (int p = 0; p < 160 * 120; ++p) pixels += std::string("\xa0\x0f", 2);
  pixels.replace(pixels.size() / 2, 2, "\xff\xff");
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 11; ++i) {
    messages.push_back({"/camera", std::string(kImage), stampOf(i),
                        test::imageMessage({stampOf(i), 160, 120, "mono16", pixels})});
  }
  test::writeDb3(folder.path() / "a.db3", messages);
  const Played played(folder.path() / "a.db3");
  CHECK(played.frames.size() == 11);
  REQUIRE(played.findings().size() == 1);
  CHECK_THAT(played.findings()[0], Catch::Contains("below 4096"));
  const Played right(folder.path() / "a.db3", {{"bits", std::int64_t{12}}});
  CHECK(right.frames[0].left.row(0)[0] == 250);
}

TEST_CASE("odometry without any time in common with the images is not used") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages = {greyImage("/camera", 0), greyImage("/camera", 1)};
  for (int i = 0; i < 3; ++i) {
    const std::int64_t stamp = stampOf(i) - 3'600'000'000'000;  // another clock
    messages.push_back(
        {"/odom", std::string(kOdometry), stampOf(i), test::odometryMessage(stamp, i, 0, 0)});
  }
  test::writeDb3(folder.path() / "a.db3", messages);
  const Played played(folder.path());
  REQUIRE(played.frames.size() == 2);
  CHECK(played.frames[1].sensors.empty());
  REQUIRE(played.findings().size() == 1);
  CHECK_THAT(played.findings()[0], Catch::Contains("measures no motion between the images"));
}

TEST_CASE("of a bag in several files each must be there") {
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "x_0.db3", pairMessages(4));
  test::writeBytes(folder.path() / "metadata.yaml",
                   "rosbag2_bagfile_information:\n  relative_file_paths: [x_0.db3, x_1.db3]\n");
  CHECK(Played(folder.path()).message ==
        (folder.path() / "x_1.db3").string() +
            ": is missing, and metadata.yaml names it; copy the whole folder of the bag");
}

TEST_CASE("a rectified image is one by its data or its name's last part, not by any \"rect\"",
          "[data]") {
  const auto bag = test::dataOrSkip("cases/topic_contains_rect.mcap");
  if (!bag) return;
  Played played(*bag);
  CHECK(played.message.empty());
  CHECK_FALSE(played.info.rig.calibrated);
  RawRig raw;
  REQUIRE(played.source.rawRig(raw).isOk());
  REQUIRE(raw.cameras.size() == 2);
  CHECK(raw.cameras[0].distortion.norm() > 0);
}

TEST_CASE("zeros that a driver adds to the coefficients are none", "[data]") {
  const auto bag = test::dataOrSkip("cases/distortion_padded_with_zeros.mcap");
  if (!bag) return;
  CHECK(Played(*bag).message.empty());
}

TEST_CASE("a positive P[3] of the right camera is reported, and the images are used", "[data]") {
  const auto bag = test::dataOrSkip("cases/positive_tx.mcap");
  if (!bag) return;
  const Played played(*bag);
  CHECK(played.message.empty());
  REQUIRE_FALSE(played.findings().empty());
  CHECK_THAT(played.findings()[0], Catch::Contains("has a positive P[3]"));
}

TEST_CASE("depth in a CompressedImage is no camera, and can be named", "[data]") {
  const auto bag = test::dataOrSkip("cases/depth_in_compressed_image.mcap");
  if (!bag) return;
  const Played played(*bag);
  for (const auto& finding : played.context.findings) {
    if (finding.message.find("used as left") == std::string::npos) continue;
    CHECK(finding.where.find("depth") == std::string::npos);
  }
}

}  // namespace tolman::ros_bag
