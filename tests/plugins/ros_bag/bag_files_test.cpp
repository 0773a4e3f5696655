// SPDX-License-Identifier: BSD-3-Clause
// The containers: messages of MCAP files, ROS 1 bags and databases, whole, cut off and damaged.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "bag_case.hpp"
#include "mcap_file.hpp"
#include "ros1_case.hpp"
#include "ros1_file.hpp"
#include "sqlite_file.hpp"

namespace tolman::ros_bag {
namespace {

FileBytes fileOf(const test::TemporaryFolder& folder, const std::string& bytes) {
  test::writeBytes(folder.path() / "bag", bytes);
  auto file = FileBytes::open(folder.path() / "bag");
  REQUIRE(file.isOk());
  return std::move(file).value();
}

ReadFile readMcap(const std::string& bytes) {
  const test::TemporaryFolder folder;
  FileBytes file = fileOf(folder, bytes);
  REQUIRE(McapFile::isMcap(file));
  McapFile bag(std::move(file));
  return ReadFile(bag);
}

ReadFile readRos1(const std::string& bytes) {
  const test::TemporaryFolder folder;
  auto bag = Ros1File::open(fileOf(folder, bytes));
  REQUIRE(bag.isOk());
  return ReadFile(*bag.value());
}

std::string refusalOf(const std::string& ros1) {
  const test::TemporaryFolder folder;
  return Ros1File::open(fileOf(folder, ros1)).status().message();
}

ReadFile readDb3(const std::filesystem::path& path) {
  auto bytes = FileBytes::open(path);
  REQUIRE(bytes.isOk());
  auto bag = SqliteFile::open(path, std::move(bytes).value());
  REQUIRE(bag.isOk());
  return ReadFile(*bag.value());
}

std::vector<test::RosMessage> letters(int count) {
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < count; ++i) {
    messages.push_back({i % 2 == 0 ? "/a" : "/b", "std_msgs/msg/String", 100 + i,
                        std::string(static_cast<std::size_t>(i + 1), 'x')});
  }
  return messages;
}

/// Two chunks of two messages each; the bag was closed.
std::string twoChunks() {
  const std::string chunks =
      ros1Chunk(ros1Connection(0, "/a", "std_msgs/String") + ros1Message(0, 5, "one") +
                ros1Connection(1, "/b", "std_msgs/Header") + ros1Message(1, 6, "two")) +
      ros1Chunk(ros1Message(1, 7, "three") + ros1Message(0, 8, "four"));
  return ros1Start(ros1Start(0).size() + chunks.size()) + chunks +
         ros1Connection(0, "/a", "std_msgs/String") + ros1ChunkInfo(1);
}

/// All but the last `end` bytes are cut off, one more at each step: what is whole is given.
template <class ReadBytes>
void checkCuts(const std::string& bytes, std::size_t begin, std::size_t end,
               const ReadBytes& read) {
  std::size_t before = 0;
  for (std::size_t size = begin; size < end; ++size) {
    const ReadFile cut = read(bytes.substr(0, size));
    REQUIRE(cut.damage.size() == 1);
    CHECK_THAT(cut.damage[0], Catch::Contains("cut off"));
    CHECK(cut.messages.size() >= before);
    before = cut.messages.size();
  }
}

}  // namespace

TEST_CASE("messages of an MCAP file with and without chunks, in every compression") {
  for (const test::McapStyle& style :
       {test::McapStyle{"", false}, test::McapStyle{""}, test::McapStyle{"zstd"},
        test::McapStyle{"lz4"}, test::McapStyle{"zstd", true, 1},
        test::McapStyle{"lz4", true, 50}}) {
    const ReadFile read = readMcap(test::mcapBytes(letters(10), style));
    CHECK(read.damage.empty());
    REQUIRE(read.messages.size() == 10);
    CHECK(read.messages[3] == "/b std_msgs/msg/String 103 xxxx");
    CHECK(read.again[7] == std::string(8, 'x'));
  }
}

TEST_CASE("messages of a ROS 1 bag, in chunks and outside of them") {
  const ReadFile read = readRos1(twoChunks());
  CHECK(read.damage.empty());
  REQUIRE(read.messages.size() == 4);
  CHECK(read.messages[0] == "/a std_msgs/msg/String 5000000007 one");
  CHECK(read.messages[2] == "/b std_msgs/msg/Header 7000000007 three");
  CHECK(read.again == std::vector<std::string>{"one", "two", "three", "four"});
  const std::string alone = ros1Connection(3, "/a", "std_msgs/String") + ros1Message(3, 1, "x");
  CHECK(readRos1(ros1Start(1) + alone).messages ==
        std::vector<std::string>{"/a std_msgs/msg/String 1000000007 x"});
}

TEST_CASE("messages of a database: as they are, compressed one by one, in a compressed file") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "bag.db3";
  const std::vector<test::RosMessage> messages = {
      {"/a", "T", 5, "one"}, {"/b", "T", 6, "two"}, {"/a", "T", 7, std::string(5000, '3')}};
  for (const int way : {0, 1, 2}) {
    std::filesystem::remove(path);
    test::writeDb3(path, messages, way == 1);
    if (way == 2) {
      std::ifstream stream(path, std::ios::binary);
      test::writeBytes(path, test::packedByZstd({std::istreambuf_iterator<char>(stream), {}}));
    }
    const ReadFile read = readDb3(path);
    CHECK(read.damage.empty());
    CHECK(read.again == std::vector<std::string>{"one", "two", std::string(5000, '3')});
  }
}

TEST_CASE("a recording that was cut off gives what is whole, and says so once") {
  const std::string mcap = test::mcapBytes(letters(12), {"zstd"});
  checkCuts(mcap, 8, mcap.size() - 60, readMcap);
  const std::string ros1 = twoChunks();
  const std::size_t index_at =
      ros1.size() - ros1ChunkInfo(1).size() - ros1Connection(0, "/a", "std_msgs/String").size();
  checkCuts(ros1, ros1Start(0).size() + 1, index_at, readRos1);
  CHECK_THAT(readRos1(ros1Start(0)).damage.at(0), Catch::Contains("cut off"));  // killed
}

TEST_CASE("a damaged chunk is named, and the others are used") {
  std::string changed = test::mcapBytes(letters(9), {""});
  changed[changed.find("xxxxx")] = 'y';  // in the second chunk
  const ReadFile sums = readMcap(changed);
  CHECK(sums.messages.size() == 6);
  REQUIRE(sums.damage.size() == 1);
  CHECK_THAT(sums.damage[0], Catch::Contains("wrong check sum"));
  CHECK_THAT(readMcap(test::mcapBytes(letters(3), {"brotli"})).damage.at(0),
             Catch::Contains("unknown compression"));

  const auto ros1 = [](const std::string& chunk) {
    const ReadFile read =
        readRos1(ros1Start(1) + chunk +
                 ros1Chunk(ros1Connection(0, "/a", "std_msgs/String") + ros1Message(0, 5, "x")));
    CHECK(read.messages.size() == 1);
    return read.damage.empty() ? "" : read.damage.front();
  };
  const std::string place = "has a chunk at byte " + std::to_string(ros1Start(0).size()) + " that ";
  for (const char* how : {"none", "bz2", "lz4"}) {
    CHECK(ros1(ros1Chunk("x", how, 100)) == place + "does not unpack");
  }
  CHECK(ros1(ros1Chunk("x", "none", 1 << 30)) == place + "claims more than 256 MiB");
  CHECK(ros1(ros1Chunk("xxxxx")) == place + "ends in a record");
  CHECK(ros1(ros1Chunk(ros1Message(9, 1, "x"))).starts_with("has a damaged message"));
}

TEST_CASE("lengths that lie do no harm") {
  const std::string mcap = test::mcapBytes(letters(3), {"", false});
  const std::string ros1 = twoChunks();
  for (std::size_t at = 8; at < mcap.size(); ++at) {
    std::string changed = mcap;
    changed[at] = '\xff';
    CHECK(readMcap(changed).messages.size() <= 3);
  }
  for (std::size_t at = ros1Start(0).size(); at < ros1.size(); ++at) {
    std::string changed = ros1;
    changed[at] = '\xff';
    CHECK(readRos1(changed).messages.size() <= 4);
  }
}

TEST_CASE("other versions, encrypted bags and no bags are refused") {
  CHECK_THAT(refusalOf("#ROSBAG V1.2\n"), Catch::Contains("another version than 2.0"));
  CHECK_THAT(refusalOf("#ROSBAG V2.0\n"), Catch::Contains("is cut off"));
  CHECK(refusalOf("#ROSBAG V2.0\n" + ros1Record({ros1Op('\2')}, "")) ==
        "does not begin as a ROS 1 bag does; copy it again");
  CHECK(refusalOf(ros1Start(0, "rosbag/AesCbcEncryptor")) ==
        "is an encrypted ROS 1 bag; decrypt it (`rosbag decrypt`)");
}

TEST_CASE("a damaged database and one that is no bag") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "bag.db3";
  test::writeDb3(path, {{"/a", "T", 5, std::string(20000, '1')}, {"/b", "T", 6, "two"}});
  {
    std::fstream bytes(path, std::ios::binary | std::ios::in | std::ios::out);
    bytes.seekp(4096);  // within the first message
    bytes << std::string(12000, '\xff');
  }
  CHECK_THAT(readDb3(path).damage.at(0), Catch::Contains("is damaged"));
  test::writeBytes(path, std::string("SQLite format 3\0", 16) + std::string(2000, 'x'));
  auto bytes = FileBytes::open(path);
  CHECK_THAT(SqliteFile::open(path, std::move(bytes).value()).status().message(),
             Catch::Contains("is no database that can be read"));
}

}  // namespace tolman::ros_bag
