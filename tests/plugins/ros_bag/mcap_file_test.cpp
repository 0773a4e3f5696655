// SPDX-License-Identifier: BSD-3-Clause
#include "mcap_file.hpp"

#include <catch2/catch.hpp>

#include "bag_case.hpp"

namespace tolman::ros_bag {
namespace {

struct Read {
  std::vector<std::string> messages;
  std::vector<std::string> again;
  std::vector<std::string> problems;
  std::string lost;
};

Read readAll(const std::string& bytes) {
  const test::TemporaryFolder folder;
  test::writeBytes(folder.path() / "bag.mcap", bytes);
  auto file = FileBytes::open(folder.path() / "bag.mcap");
  REQUIRE(file.isOk());
  REQUIRE(McapFile::isMcap(file.value()));
  McapFile bag(std::move(file).value());
  Read read;
  std::vector<MessagePlace> places;
  FileDamage damage;
  bag.visit(
      [&](const Topic& topic, std::int64_t log_ns, const MessagePlace& place, Bytes message) {
        read.messages.push_back(topic.name + std::to_string(log_ns) + std::string(asText(message)));
        places.push_back(place);
      },
      damage);
  read.problems = damage.problems;
  read.lost = lostText(damage.lost);
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    const auto message = bag.read(*place);
    REQUIRE(message.isOk());
    read.again.insert(read.again.begin(), std::string(asText(message.value())));
  }
  return read;
}

std::vector<test::RosMessage> letters(int count) {
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < count; ++i) {
    messages.push_back({i % 2 == 0 ? "/a" : "/b", "std_msgs/msg/String", 100 + i,
                        std::string(static_cast<std::size_t>(i + 1), 'x')});
  }
  return messages;
}

}  // namespace

TEST_CASE("messages with and without chunks, in every compression") {
  for (const test::McapStyle& style :
       {test::McapStyle{"", false}, test::McapStyle{""}, test::McapStyle{"zstd"},
        test::McapStyle{"lz4"}, test::McapStyle{"zstd", true, 1},
        test::McapStyle{"lz4", true, 50}}) {
    const Read read = readAll(test::mcapBytes(letters(10), style));
    CHECK(read.problems.empty());
    REQUIRE(read.messages.size() == 10);
    CHECK(read.messages[3] == "/b103xxxx");
    CHECK(read.again[7] == std::string(8, 'x'));
  }
}

TEST_CASE("a recording that was cut off gives what is whole, and one problem") {
  const std::string bytes = test::mcapBytes(letters(12), {"zstd"});
  std::size_t before = 0;
  constexpr std::size_t kEnd = 13 + 29 + 8;  // end of the data, footer, magic
  for (std::size_t size = 8; size <= bytes.size() - kEnd; ++size) {
    const Read read = readAll(bytes.substr(0, size));
    CHECK(read.problems.size() == 1);
    CHECK(read.problems[0].find("cut off") != std::string::npos);
    CHECK(read.messages.size() >= before);
    before = read.messages.size();
  }
  CHECK(before == 12);
}

TEST_CASE("a changed byte in a chunk is told by its check sum") {
  std::string bytes = test::mcapBytes(letters(9), {""});
  bytes[bytes.find("xxxxx")] = 'y';  // in the second chunk
  const Read read = readAll(bytes);
  CHECK(read.messages.size() == 6);
  REQUIRE(read.problems.size() == 1);
  CHECK(read.problems[0].find("wrong check sum") != std::string::npos);
}

TEST_CASE("messages of a damaged chunk are counted by the indices") {
  for (const char* compression : {"", "zstd", "lz4"}) {
    std::string bytes = test::mcapBytes(letters(9), {compression, true, 3, true, "cdr", true});
    CHECK(readAll(bytes).problems.empty());
    CHECK(readAll(bytes).lost.empty());
    const std::size_t second = bytes.find("\x07", bytes.find("\x06") + 60);
    REQUIRE(second != std::string::npos);
    std::string first = bytes;
    const std::size_t name = first.find(compression, 60);
    first[name + 30] = static_cast<char>(first[name + 30] ^ 0x55);  // with the names of the topics
    const Read read = readAll(first);
    CHECK(read.messages.size() == 6);
    CHECK(read.lost == "2 messages of /a and 1 message of /b");
    CHECK(read.problems.size() == 1);
  }
}

TEST_CASE("without its summary a file is told, and its messages are read") {
  const std::string bytes = test::mcapBytes(letters(9), {"zstd", true, 3, true, "cdr", true});
  for (const std::size_t less : {1U, 8U, 20U, 37U, 60U}) {
    const Read read = readAll(bytes.substr(0, bytes.size() - less));
    CHECK(read.messages.size() == 9);
    REQUIRE(read.problems.size() == 1);
    CHECK(read.problems[0].starts_with("the index at its end is missing"));
  }
  std::string wrong = bytes;
  wrong[bytes.size() - 50] = static_cast<char>(wrong[bytes.size() - 50] ^ 1);
  REQUIRE(readAll(wrong).problems.size() == 1);
  CHECK(
      readAll(wrong).problems[0].starts_with("the index at its end does not match its check sum"));
}

TEST_CASE("times of recording before 1970 are told once, with the topic") {
  auto messages = letters(6);
  for (const std::size_t i : {1U, 3U}) messages[i].log_ns = -5'000'000'000;
  const Read read = readAll(test::mcapBytes(messages));
  CHECK(read.messages.size() == 4);
  REQUIRE(read.problems.size() == 1);
  CHECK(read.problems[0].find("was recorded at -5000000000 ns, before 1970, and 1 more like it: "
                              "the clock was wrong") != std::string::npos);
  CHECK(read.lost == "2 messages of /b");
}

TEST_CASE("lengths that lie do no harm") {
  std::string bytes = test::mcapBytes(letters(3), {"", false});
  const std::size_t at = bytes.find("/a") - 9;
  for (std::size_t i = 0; i < 8; ++i) {
    std::string changed = bytes;
    changed[at + i] = '\xff';
    CHECK(readAll(changed).messages.size() <= 3);
  }
  std::string unknown = test::mcapBytes(letters(3), {"brotli"});
  CHECK(readAll(unknown).problems.at(0).find("unknown compression") != std::string::npos);
}

TEST_CASE("messages without a check sum of their own are compared with that of the data") {
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 7; ++i) {
    messages.push_back({"/a", "t", i, "message " + std::to_string(i)});
  }
  const int header = 8 + 9 + 16;  // magic bytes; kind, length and two texts of 4 letters
  test::McapStyle style;
  style.sums = false;
  style.chunks = GENERATE(true, false);
  style.indexed = GENERATE(true, false);
  style.summed_from = GENERATE_COPY(0, 8, header, -1);
  CAPTURE(style.chunks, style.indexed, style.summed_from);
  std::string bytes = test::mcapBytes(messages, style);
  CHECK(readAll(bytes).problems.empty());
  bytes[bytes.find("message 3")] = 'M';
  const Read changed = readAll(bytes);
  CHECK(changed.messages.size() == 7);
  if (style.summed_from < 0) {
    CHECK(changed.problems.empty());  // nothing can tell
  } else {
    REQUIRE(changed.problems.size() == 1);
    CHECK(changed.problems[0].starts_with("the messages do not match the check sum of the file"));
  }
}

TEST_CASE("a summary that counts all messages together tells that some are missing") {
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 7; ++i) messages.push_back({"/a", "t", i, "m" + std::to_string(i)});
  test::McapStyle style;
  style.chunks = false;
  style.indexed = true;
  style.totals_only = true;
  std::string bytes = test::mcapBytes(messages, style);
  CHECK(readAll(bytes).lost.empty());
  const std::size_t kind = bytes.find("m3") - 2 * 8 - 4 - 2 - 9;  // before times, number, channel
  REQUIRE(bytes[kind] == 5);
  bytes[kind] = 100;  // a record of a kind that is not known
  CHECK_THAT(readAll(bytes).lost, Catch::Contains("1 message"));
}

}  // namespace tolman::ros_bag
