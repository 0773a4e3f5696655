// SPDX-License-Identifier: BSD-3-Clause
#include "metadata_file.hpp"

#include <catch2/catch.hpp>

#include "bag_case.hpp"

namespace tolman::ros_bag {

TEST_CASE("the names of the files, as several versions of rosbag2 write them") {
  CHECK(filesInMetadata("rosbag2_bagfile_information:\n  version: 4\n  relative_file_paths:\n"
                        "    - a_0.db3\n    - 'a_1.db3'\r\n  duration:\n    - x\n") ==
        std::vector<std::string>{"a_0.db3", "a_1.db3"});
  CHECK(filesInMetadata("  relative_file_paths:\n  - b/b_0.mcap") ==
        std::vector<std::string>{"b/b_0.mcap"});
  CHECK(filesInMetadata("version: 5\n").empty());
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
  CHECK(messagesInMetadata(text) == 12);
  CHECK_FALSE(messagesInMetadata("message_count: many\n"));
  CHECK_FALSE(messagesInMetadata("message_count: 12x\n"));
  CHECK_FALSE(messagesInMetadata("version: 5\n"));
  const test::TemporaryFolder folder;
  CHECK(missingMessages(folder.path(), 3).empty());
  test::writeBytes(folder.path() / "metadata.yaml", text);
  CHECK(missingMessages(folder.path(), 12).empty());
  CHECK(missingMessages(folder.path(), 9) ==
        (folder.path() / "metadata.yaml").string() +
            ": says that the bag has 12 messages, its files have 9; copy the whole folder of the "
            "bag");
}

}  // namespace tolman::ros_bag
