// SPDX-License-Identifier: BSD-3-Clause
// Bags with one changed byte, and bags that were split: what is lost is told, with topic and
// number; a bag is never taken for whole that is not.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "bag_case.hpp"
#include "ros1_case.hpp"
#include "support/few_descriptors.hpp"

namespace tolman::ros_bag {
namespace {

const ParameterValues kSkipDamage = {{"on_corrupt", std::string("skip")}};
constexpr int kPairs = 12;

/// The values of the images of both cameras, frame by frame.
std::string picturesOf(const Played& played) {
  std::string text;
  for (const Frame& frame : played.frames) {
    for (const Image* image : {&frame.left, &frame.right}) {
      for (int y = 0; y < image->height(); ++y) {
        text.append(reinterpret_cast<const char*>(image->row(y)),
                    static_cast<std::size_t>(image->width()));
      }
    }
  }
  return text;
}

bool isTold(const Played& played) {
  return !played.message.empty() || !played.context.log.empty() ||
         std::ranges::any_of(played.frames, [](const Frame& f) { return !f.defect.empty(); });
}

/// Changes every `step`th byte of a bag from `begin` on. `are_summed`: the format has check sums of
/// its messages, so that pixels are the same, too.
void changeBytes(const std::string& bag, const std::string& name, std::size_t begin,
                 std::size_t step, bool are_summed, const ParameterValues& camera = {}) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / name;
  test::writeBytes(path, bag);
  const Played sound(path, camera);
  REQUIRE(sound.message.empty());
  REQUIRE(sound.frames.size() == kPairs);
  REQUIRE(sound.context.log.empty());
  int told = 0;
  for (std::size_t at = begin; at < bag.size(); at += step) {
    std::string changed = bag;
    changed[at] = static_cast<char>(changed[at] ^ (1 << at % 8));
    test::writeBytes(path, changed);
    for (const bool skip : {false, true}) {
      ParameterValues how = camera;
      if (skip) how.insert(kSkipDamage.begin(), kSkipDamage.end());
      const Played played(path, how);
      INFO(name << ", byte " << at << ", " << played.message);
      told += isTold(played) ? 1 : 0;
      if (isTold(played)) continue;
      CHECK(played.frames.size() == kPairs);
      if (are_summed) CHECK(picturesOf(played) == picturesOf(sound));
    }
  }
  CHECK(told > 40);
}

/// An Image of ROS 1, 8x6 px.
std::string ros1Image(std::uint32_t second, char value) {
  return rawNumber(second) + rawNumber(second) + rawNumber(0U) + ros1Text("camera") +
         rawNumber(6U) + rawNumber(8U) + ros1Text("mono8") + '\0' + rawNumber(8U) +
         ros1Text(std::string(48, value));
}

/// Four chunks of three pairs each, with all indices.
std::string ros1Pairs() {
  const std::string topics = ros1Connection(0, "/left/image_rect", "sensor_msgs/Image") +
                             ros1Connection(1, "/right/image_rect", "sensor_msgs/Image");
  std::string chunks;
  std::string infos;
  for (std::uint32_t begin = 1; begin <= kPairs; begin += 3) {
    std::string records = begin == 1 ? topics : "";
    for (std::uint32_t i = begin; i < begin + 3; ++i) {
      records += ros1Message(0, i, ros1Image(i, static_cast<char>(i))) +
                 ros1Message(1, i, ros1Image(i, static_cast<char>(100 + i)));
    }
    chunks += ros1Chunk(records) + ros1ChunkIndex(0, 3) + ros1ChunkIndex(1, 3);
    infos += ros1ChunkInfo(3);
  }
  return ros1Start(ros1Start(0).size() + chunks.size()) + chunks + topics + infos;
}

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool contains(const std::vector<std::string>& texts, const std::string& part) {
  return std::ranges::any_of(
      texts, [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

/// A folder of three files of four pairs each, as rosbag2 splits a recording.
void writeSplit(const std::filesystem::path& folder) {
  const auto messages = pairMessages(kPairs);
  const std::vector<test::RosMessage> infos(messages.begin(), messages.begin() + 2);
  std::string files;
  for (int part = 0; part < 3; ++part) {
    const std::string name = "bag_" + std::to_string(part) + ".mcap";
    std::vector<test::RosMessage> own = infos;
    if (part > 0) own.clear();
    own.insert(own.end(), messages.begin() + 2 + 8 * part, messages.begin() + 10 + 8 * part);
    test::writeBytes(folder / name, test::mcapBytes(own, {"zstd", true, 4}));
    files += "    - " + name + "\n";
  }
  std::string topics;
  for (const char* side : {"left", "right"}) {
    topics += std::string("    - topic_metadata:\n        name: /") + side +
              "/image_rect\n        type: sensor_msgs/msg/Image\n      message_count: 12\n";
  }
  test::writeBytes(folder / "metadata.yaml",
                   "rosbag2_bagfile_information:\n  relative_file_paths:\n" + files +
                       "  message_count: 26\n  topics_with_message_count:\n" + topics);
}

}  // namespace

TEST_CASE("no changed byte of an MCAP file is a false success") {
  for (const char* compression : {"", "zstd", "lz4"}) {
    const test::McapStyle style{compression, true, 6, true, "cdr", true};
    changeBytes(test::mcapBytes(pairMessages(kPairs), style), "a.mcap", 8, 5, true);
  }
}

TEST_CASE("no changed byte of a ROS 1 bag loses frames silently") {
  changeBytes(ros1Pairs(), "a.bag", 13, 3, false, {{"fx", 7.0}, {"baseline", 0.12}});
}

TEST_CASE("no changed byte of a SQLite bag loses frames silently") {
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "b.db3", pairMessages(kPairs));
  changeBytes(bytesOf(folder.path() / "b.db3"), "a.db3", 100, 37, false);
}

TEST_CASE("what a damaged chunk loses is told by run and check, with topics and numbers") {
  const test::TemporaryFolder folder;
  const test::McapStyle style{"zstd", true, 6, true, "cdr", true};
  std::string bytes = test::mcapBytes(pairMessages(kPairs), style);
  const std::size_t second = bytes.find("zstd", bytes.find("zstd") + 4);
  bytes[second + 40] = static_cast<char>(bytes[second + 40] ^ 0x55);
  const std::filesystem::path path = folder.path() / "a.mcap";
  test::writeBytes(path, bytes);
  const std::string lost =
      "3 messages of /left/image_rect and 3 messages of /right/image_rect could not be read";
  Played stopped(path);
  CHECK(stopped.frames.empty());
  CHECK(contains(stopped.findings(), lost));
  Played skipped(path, kSkipDamage);
  CHECK(skipped.message.empty());
  CHECK(skipped.frames.size() == kPairs - 3);
  CHECK(contains(skipped.context.log, lost + "; what is damaged is left out"));
  CHECK(contains(skipped.findings(), lost));
  CHECK(skipped.info.description.ends_with("; " + lost));
}

TEST_CASE("a bag all of whose times of recording are before 1970 names the topics") {
  const test::TemporaryFolder folder;
  auto messages = pairMessages(4);
  for (test::RosMessage& message : messages) message.log_ns = -5'000'000'000;
  test::writeDb3(folder.path() / "a.db3", messages);
  test::writeBytes(folder.path() / "a.mcap", test::mcapBytes(messages));
  for (const char* name : {"a.db3", "a.mcap"}) {
    CHECK(Played(folder.path() / name).message.find("the clock was wrong") != std::string::npos);
    const Played skipped(folder.path() / name, {{"on_corrupt", std::string("skip")},
                                                {"left", std::string("/left/image_rect")}});
    CHECK(skipped.message ==
          "/left/image_rect: none of its 4 messages could be read; copy the bag again, or record "
          "it again");
  }
}

TEST_CASE("bags that cannot be opened for want of descriptors are told as such") {
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "a.db3", pairMessages(2));
  test::writeBytes(folder.path() / "a.mcap", test::mcapBytes(pairMessages(2)));
  for (const auto& [name, left] : {std::pair{"a.mcap", 0}, {"a.db3", 0}, {"a.db3", 1}}) {
    const test::FewDescriptors few(left);
    CHECK(Played(folder.path() / name).message ==
          (folder.path() / name).string() +
              ": cannot be opened; allow more open files (`ulimit -n`)");
  }
}

TEST_CASE("parts of a split bag that are missing, damaged or not named are told") {
  const test::TemporaryFolder folder;
  writeSplit(folder.path());
  const Played sound(folder.path());
  CHECK(sound.frames.size() == kPairs);
  CHECK(sound.context.log.empty());
  const std::string last = bytesOf(folder.path() / "bag_2.mcap");
  test::writeBytes(folder.path() / "bag_3.mcap", last);
  CHECK(contains(Played(folder.path()).context.log, "bag_3.mcap: is not read, because"));
  std::filesystem::remove(folder.path() / "bag_3.mcap");
  test::writeBytes(folder.path() / "bag_2.mcap", last.substr(0, last.size() / 2));
  const Played cut(folder.path(), kSkipDamage);
  CHECK(cut.frames.size() == kPairs - 4);
  CHECK(contains(cut.context.log,
                 "4 messages of /left/image_rect and 4 messages of "
                 "/right/image_rect could not be read"));
  std::filesystem::remove(folder.path() / "bag_2.mcap");
  CHECK(Played(folder.path()).message.find("bag_2.mcap: is missing, and metadata.yaml names it") !=
        std::string::npos);
  std::filesystem::remove(folder.path() / "metadata.yaml");
  std::filesystem::remove(folder.path() / "bag_1.mcap");
  test::writeBytes(folder.path() / "bag_2.mcap", last);
  CHECK(contains(Played(folder.path()).context.log, "part 1 of the recording is missing"));
}

}  // namespace tolman::ros_bag
