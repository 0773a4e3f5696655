// SPDX-License-Identifier: BSD-3-Clause
#include "metadata_file.hpp"

#include <catch2/catch.hpp>

#include "bag_case.hpp"

namespace tolman::ros_bag {
namespace {

std::vector<std::string> filesOf(const std::string& text) { return parseMetadata(text).files; }
std::optional<std::int64_t> messagesOf(const std::string& text) {
  return parseMetadata(text).messages;
}

}  // namespace

TEST_CASE("the names of the files, as several versions of rosbag2 write them") {
  CHECK(filesOf("rosbag2_bagfile_information:\n  version: 4\n  relative_file_paths:\n"
                "    - a_0.db3\n    - 'a_1.db3'\r\n  duration:\n    - x\n") ==
        std::vector<std::string>{"a_0.db3", "a_1.db3"});
  CHECK(filesOf("  relative_file_paths:\n  - b/b_0.mcap") ==
        std::vector<std::string>{"b/b_0.mcap"});
  CHECK(filesOf("version: 5\n").empty());
}

TEST_CASE("files of a folder with and without metadata") {
  const test::TemporaryFolder folder;
  const auto names = [&] {
    const auto files = findBagFiles(folder.path());
    std::vector<std::string> found;
    if (!files.isOk()) return std::vector<std::string>{files.status().message()};
    for (const auto& file : files.value()) found.push_back(file.filename().string());
    return found;
  };
  CHECK(names() == std::vector<std::string>{folder.path().string() +
                                            ": has no .mcap, .db3 or .bag file; check the path"});
  for (const char* name : {"bag_10.mcap", "bag_2.mcap", "bag_1.mcap", "notes.txt"}) {
    test::writeBytes(folder.path() / name, "x");
  }
  CHECK(names() == std::vector<std::string>{"bag_1.mcap", "bag_2.mcap", "bag_10.mcap"});
  test::writeBytes(folder.path() / "metadata.yaml", "relative_file_paths:\n- ../x/bag_2.mcap\n");
  CHECK(names() == std::vector<std::string>{"bag_2.mcap"});
  test::writeBytes(folder.path() / "metadata.yaml", "relative_file_paths:\n- bag_7.mcap\n");
  CHECK(names().at(0).find("bag_7.mcap: is missing, and metadata.yaml names it") !=
        std::string::npos);
}

TEST_CASE(
    "the number of messages is the first of metadata.yaml; fewer in the files are a problem") {
  const std::string text =
      "rosbag2_bagfile_information:\n  version: 5\n  message_count: 12\n"
      "  topics_with_message_count:\n    - topic_metadata: {name: /a}\n      message_count: 7\n";
  CHECK(messagesOf(text) == 12);
  CHECK_FALSE(messagesOf("message_count: many\n"));
  CHECK_FALSE(messagesOf("message_count: 12x\n"));
  CHECK_FALSE(messagesOf("version: 5\n"));
  const test::TemporaryFolder folder;
  const auto missing = [&](std::int64_t found) {
    return missingMessages(folder.path(), metadataOf(folder.path()), found);
  };
  CHECK(missing(3).empty());
  test::writeBytes(folder.path() / "metadata.yaml", text);
  CHECK(missing(12).empty());
  CHECK(missing(9) ==
        (folder.path() / "metadata.yaml").string() +
            ": says that the bag has 12 messages, of which 9 could be read; copy the whole folder "
            "of the bag, or use them by on_corrupt: skip");
}

TEST_CASE("the total and the topics, as rosbag2 and the package rosbags write them") {
  const BagMetadata rosbag2 = parseMetadata(
      "rosbag2_bagfile_information:\n  version: 9\n  message_count: 19\n"
      "  topics_with_message_count:\n    - topic_metadata:\n        name: /a\n"
      "        type: std_msgs/msg/String\n        serialization_format: cdr\n"
      "        offered_qos_profiles:\n          - history: keep_last\n            depth: 10\n"
      "      message_count: 7\n    - topic_metadata:\n        name: \"/b\"\n"
      "      message_count: 12\n  compression_format: \"\"\n"
      "  relative_file_paths:\n    - x_0.mcap\n  files:\n    - path: x_0.mcap\n"
      "      message_count: 11\n");
  CHECK(rosbag2.messages == 19);
  REQUIRE(rosbag2.topics.size() == 2);
  CHECK(rosbag2.topics.at("/a").messages == 7);
  CHECK(rosbag2.topics.at("/a").type == "std_msgs/msg/String");
  CHECK(rosbag2.topics.at("/a").encoding == "cdr");
  CHECK(rosbag2.topics.at("/b").messages == 12);
  // Sorted keys: the number of the first file stands before that of the bag.
  const BagMetadata rosbags = parseMetadata(
      "rosbag2_bagfile_information:\n  files:\n  - message_count: 4\n    path: a.mcap\n"
      "  - message_count: 5\n    path: b.mcap\n  message_count: 9\n"
      "  relative_file_paths:\n  - a.mcap\n  - b.mcap\n"
      "  topics_with_message_count:\n  - message_count: 9\n    topic_metadata:\n"
      "      name: /c\n      type: T\n");
  CHECK(rosbags.messages == 9);
  CHECK(rosbags.files == std::vector<std::string>{"a.mcap", "b.mcap"});
  REQUIRE(rosbags.topics.size() == 1);
  CHECK(rosbags.topics.at("/c").messages == 9);
}

TEST_CASE("files that metadata.yaml does not name, and missing parts, are told") {
  const test::TemporaryFolder folder;
  const auto odd = [&] {
    const auto files = findBagFiles(folder.path());
    REQUIRE(files.isOk());
    return oddFiles(folder.path(), metadataOf(folder.path()), files.value());
  };
  for (const char* name : {"x_0.mcap", "x_1.mcap", "x_3.mcap"}) {
    test::writeBytes(folder.path() / name, "x");
  }
  CHECK(odd() == std::vector<std::string>{
                     folder.path().string() +
                     ": part 2 of the recording is missing, while there are others up to 3; copy "
                     "the whole folder of the bag"});
  test::writeBytes(folder.path() / "x_2.mcap", "x");
  CHECK(odd().empty());
  test::writeBytes(folder.path() / "metadata.yaml",
                   "relative_file_paths:\n- x_0.mcap\n- x_1.mcap\n- x_3.mcap\n");
  REQUIRE(odd().size() == 1);
  CHECK(odd()[0].find("x_2.mcap: is not read, because metadata.yaml does not name it") !=
        std::string::npos);
  std::filesystem::rename(folder.path() / "x_2.mcap", folder.path() / "x_3.mcap.zstd");
  CHECK(odd().empty());  // the packed one
}

}  // namespace tolman::ros_bag
