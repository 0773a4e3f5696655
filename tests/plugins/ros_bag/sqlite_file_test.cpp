// SPDX-License-Identifier: BSD-3-Clause
#include "sqlite_file.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "bag_case.hpp"

namespace tolman::ros_bag {
namespace {

struct Database {
  test::TemporaryFolder folder;
  std::filesystem::path path = folder.path() / "bag.db3";

  Result<std::unique_ptr<SqliteFile>> open() const {
    auto bytes = FileBytes::open(path);
    REQUIRE(bytes.isOk());
    return SqliteFile::open(path, std::move(bytes).value());
  }
  std::vector<std::string> messages(std::vector<std::string>& problems) const {
    std::vector<std::string> found;
    const auto file = open();
    REQUIRE(file.isOk());
    FileDamage damage;
    file.value()->visit(
        [&](const Topic& topic, std::int64_t, const MessagePlace& place, Bytes message) {
          found.push_back(topic.name + std::string(asText(message)));
          const auto again = file.value()->read(place);
          REQUIRE(again.isOk());
          CHECK(asText(again.value()) == asText(message));
        },
        damage);
    problems = damage.problems;
    return found;
  }
};

const std::vector<test::RosMessage> kMessages = {
    {"/a", "T", 5, "one"}, {"/b", "T", 6, "two"}, {"/a", "T", 7, std::string(5000, '3')}};

}  // namespace

TEST_CASE("messages as they are, compressed one by one, and in a compressed file") {
  const Database database;
  for (const int way : {0, 1, 2}) {
    std::filesystem::remove(database.path);
    test::writeDb3(database.path, kMessages, way == 1);
    if (way == 2) {
      std::ifstream stream(database.path, std::ios::binary);
      const std::string plain{std::istreambuf_iterator<char>(stream), {}};
      test::writeBytes(database.path, test::packedByZstd(plain));
    }
    std::vector<std::string> problems;
    const auto found = database.messages(problems);
    CHECK(problems.empty());
    REQUIRE(found.size() == 3);
    CHECK(found[1] == "/btwo");
    CHECK(found[2] == "/a" + std::string(5000, '3'));
  }
}

TEST_CASE("times of recording before 1970 are told once, and not as damage") {
  const Database database;
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 4; ++i) messages.push_back(greyImage("/camera", i));
  for (const std::size_t i : {1U, 2U}) messages[i].log_ns = -5'000'000'000;
  test::writeDb3(database.path, messages);
  std::vector<std::string> problems;
  CHECK(database.messages(problems).size() == 2);
  CHECK(problems == std::vector<std::string>{
                        "message 2 was recorded at -5000000000 ns, before 1970, and 1 more like "
                        "it: the clock was wrong; correct the times of recording, or leave "
                        "such messages out by on_corrupt: skip"});
}

TEST_CASE("a damaged database and one that is no bag") {
  const Database database;
  test::writeDb3(database.path, kMessages);
  {
    std::fstream bytes(database.path, std::ios::binary | std::ios::in | std::ios::out);
    bytes.seekp(2048);
    bytes << std::string(3000, '\xff');
  }
  std::vector<std::string> problems;
  (void)database.messages(problems);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].find("is damaged") != std::string::npos);
  test::writeBytes(database.path, std::string("SQLite format 3\0", 16) + std::string(2000, 'x'));
  CHECK(database.open().status().message().find("is no database that can be read") !=
        std::string::npos);
}

}  // namespace tolman::ros_bag
