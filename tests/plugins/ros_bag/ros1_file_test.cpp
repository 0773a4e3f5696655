// SPDX-License-Identifier: BSD-3-Clause
#include "ros1_file.hpp"

#include <catch2/catch.hpp>

#include "ros1_case.hpp"

namespace tolman::ros_bag {
namespace {

/// Two chunks of two messages each, and the index.
std::string twoChunks() {
  const std::string begin = ros1Start(0);
  const std::string chunks =
      ros1Chunk(ros1Connection(0, "/a", "std_msgs/String") + ros1Message(0, 5, "one") +
                ros1Connection(1, "/b", "std_msgs/Header") + ros1Message(1, 6, "two")) +
      ros1Record({ros1Op('\4')}, "index of the chunk") +
      ros1Chunk(ros1Message(1, 7, "three") + ros1Message(0, 8, "four"));
  return ros1Start(begin.size() + chunks.size()) + chunks +
         ros1Connection(0, "/a", "std_msgs/String") + ros1ChunkInfo(1) + ros1ChunkInfo(1);
}

}  // namespace

TEST_CASE("messages of a ROS 1 bag, their topics and times") {
  const Ros1Read read(twoChunks());
  CHECK(read.problems.empty());
  REQUIRE(read.messages.size() == 4);
  CHECK(read.messages[0] == "/a std_msgs/msg/String 5000000007 one");
  CHECK(read.messages[2] == "/b std_msgs/msg/Header 7000000007 three");
  CHECK(read.again == std::vector<std::string>{"one", "two", "three", "four"});
}

TEST_CASE("messages outside of chunks") {
  const std::string records =
      ros1Connection(3, "/a", "std_msgs/String") + ros1Message(3, 1, "alone");
  const Ros1Read read(ros1Start(ros1Start(0).size() + records.size()) + records);
  CHECK(read.problems.empty());
  CHECK(read.messages == std::vector<std::string>{"/a std_msgs/msg/String 1000000007 alone"});
  CHECK(read.again == std::vector<std::string>{"alone"});
}

TEST_CASE("a ROS 1 bag that was cut off gives what is whole, and one problem") {
  const std::string bytes = twoChunks();
  const std::size_t index_at = bytes.size() - 2 * ros1ChunkInfo(1).size() -
                               ros1Connection(0, "/a", "std_msgs/String").size();
  std::size_t before = 0;
  for (std::size_t size = ros1Start(0).size(); size < index_at; ++size) {
    const Ros1Read read(bytes.substr(0, size));
    REQUIRE(read.problems.size() == 1);
    CHECK(read.problems[0].find("the recording was cut off") != std::string::npos);
    CHECK(read.messages.size() >= before);
    before = read.messages.size();
  }
  CHECK(before == 2);
}

TEST_CASE("messages of a damaged ROS 1 chunk are counted by either index") {
  const std::string topics =
      ros1Connection(0, "/a", "std_msgs/String") + ros1Connection(1, "/b", "std_msgs/String");
  const std::string chunks = ros1Chunk(topics + ros1Message(0, 5, "1") + ros1Message(1, 5, "2")) +
                             ros1ChunkIndex(0, 1) + ros1ChunkIndex(1, 1) +
                             ros1Chunk("no records", "lz4", 80) + ros1ChunkIndex(0, 3) +
                             ros1ChunkIndex(1, 2);
  const std::uint64_t index_at = ros1Start(0).size() + chunks.size();
  const Ros1Read by_chunk(ros1Start(index_at) + chunks);
  CHECK(by_chunk.messages.size() == 2);
  CHECK(by_chunk.lost == "3 messages of /a and 2 messages of /b");
  const Ros1Read by_end(ros1Start(index_at) + chunks + topics + ros1ChunkInfo(1) +
                        ros1ChunkInfo(4));
  CHECK(by_end.lost == "4 messages of /a and 4 messages of /b");
  const Ros1Read bad_index(ros1Start(index_at) + chunks + ros1ChunkIndex(0, 1));
  CHECK(bad_index.messages.size() == 2);
  REQUIRE(bad_index.problems.size() == 2);
  CHECK(bad_index.problems[1].starts_with("the index at its end is damaged"));
}

TEST_CASE("a ROS 1 chunk with the topics is lost, and the index at the end has them") {
  const std::string topics =
      ros1Connection(0, "/a", "std_msgs/String") + ros1Connection(1, "/b", "std_msgs/String");
  const std::string chunks =
      ros1Chunk(topics + ros1Message(0, 5, "1"), "zip") + ros1Chunk(ros1Message(1, 6, "2"));
  const Ros1Read read(ros1Start(ros1Start(0).size() + chunks.size()) + chunks + topics +
                      ros1ChunkInfo(1));
  CHECK(read.messages == std::vector<std::string>{"/b std_msgs/msg/String 6000000007 2"});
  CHECK(read.lost == "1 message of /a");
}

TEST_CASE("seconds of ROS 1 that only a wrong clock gives are told once") {
  const std::string records = ros1Connection(0, "/a", "std_msgs/String") +
                              ros1Message(0, 0xfffffffb, "x") + ros1Message(0, 0xfffffffc, "y") +
                              ros1Message(0, 0xfffffffd, "z") + ros1Message(0, 5, "sound");
  const Ros1Read read(ros1Start(ros1Start(0).size() + records.size()) + records);
  CHECK(read.messages == std::vector<std::string>{"/a std_msgs/msg/String 5000000007 sound"});
  REQUIRE(read.problems.size() == 1);
  CHECK(read.problems[0].find("was recorded at -4999999993 ns, before 1970, and 2 more like it: "
                              "the clock was wrong") != std::string::npos);
  CHECK(read.lost == "3 messages of /a");
}

TEST_CASE("other versions, encrypted bags and no bags are refused") {
  CHECK(Ros1Read("#ROSBAG V1.2\n").refusal.find("another version than 2.0") != std::string::npos);
  CHECK(Ros1Read("#ROSBAG V2.0\n").refusal.find("the recording was cut off") != std::string::npos);
  CHECK(Ros1Read("#ROSBAG V2.0\n" + ros1Record({ros1Op('\2')}, "")).refusal ==
        "does not begin as a ROS 1 bag does; copy it again");
  CHECK(Ros1Read(ros1Start(0, "rosbag/AesCbcEncryptor")).refusal ==
        "is an encrypted ROS 1 bag; decrypt it (`rosbag decrypt`)");
}

TEST_CASE("chunks that lie are told, and the others are used") {
  const auto problem = [](const std::string& chunk) {
    const std::string records =
        chunk + ros1Chunk(ros1Connection(0, "/a", "std_msgs/String") + ros1Message(0, 5, "sound"));
    const Ros1Read read(ros1Start(ros1Start(0).size() + records.size()) + records);
    CHECK(read.messages.size() == 1);
    return read.problems.empty() ? "" : read.problems.front();
  };
  const std::string place = "the chunk at byte " + std::to_string(ros1Start(0).size());
  CHECK(problem(ros1Chunk("x", "none", 1 << 30)).find("claims more than 256 MiB") !=
        std::string::npos);
  for (const char* how : {"none", "bz2", "lz4"}) {
    CHECK(problem(ros1Chunk("x", how, 100)).find(place + " does not unpack") == 0);
  }
  CHECK(problem(ros1Chunk("x", "zip")).find(place + " has an unknown compression") == 0);
  CHECK(problem(ros1Record({ros1Op('\5')}, "x")).find(place + " has a damaged header") == 0);
  CHECK(problem(ros1Chunk("xxxxx")).find(place + " ends within a record") == 0);
  CHECK(problem(ros1Chunk(ros1Message(9, 1, "x"))).find("has a damaged message") == 0);
  CHECK(problem(ros1Chunk(ros1Record({"op=?"}, "x"))).find("has a record of no known kind") == 0);
}

TEST_CASE("lengths of a ROS 1 bag that lie do no harm") {
  const std::string bytes = twoChunks();
  for (std::size_t at = 13; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = '\xff';
    CHECK(Ros1Read(changed).messages.size() <= 4);
  }
}

}  // namespace tolman::ros_bag
