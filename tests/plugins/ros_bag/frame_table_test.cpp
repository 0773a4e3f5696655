// SPDX-License-Identifier: BSD-3-Clause
#include "frame_table.hpp"

#include <catch2/catch.hpp>

namespace tolman::ros_bag {
namespace {

std::vector<BagMessage> at(const std::vector<std::int64_t>& stamps) {
  std::vector<BagMessage> messages;
  for (const std::int64_t stamp : stamps) messages.push_back({stamp, 0, {}});
  return messages;
}

BagTopic topicAt(const char* name, const std::vector<std::int64_t>& stamps) {
  BagTopic topic;
  topic.topic.name = name;
  topic.index = at(stamps);
  return topic;
}

using Matches = std::vector<std::optional<std::size_t>>;

}  // namespace

TEST_CASE("the nearest within the tolerance, none twice") {
  CHECK(matchStamps(at({10, 20, 30}), at({10, 20, 30}), 0) == Matches{0, 1, 2});
  CHECK(matchStamps(at({10, 20, 30}), at({12, 31}), 3) == Matches{0, std::nullopt, 1});
  CHECK(matchStamps(at({10, 20, 30}), at({19}), 20) == Matches{std::nullopt, 0, std::nullopt});
  CHECK(matchStamps(at({10, 20}), at({1, 2, 3, 9, 11, 21}), 5) == Matches{3, 5});
  CHECK(matchStamps(at({10}), {}, 5) == Matches{std::nullopt});
}

TEST_CASE("frames of a pair with depth") {
  const BagTopic left = topicAt("/l", {10, 20, 30, 40});
  const BagTopic right = topicAt("/r", {11, 31, 39});
  const BagTopic depth = topicAt("/d", {30});
  const auto table = makeFrameTable(left, &right, &depth, 2);
  REQUIRE(table.isOk());
  REQUIRE(table.value().rows.size() == 3);
  CHECK(table.value().left_alone == 1);
  CHECK(table.value().rows[1].left == 2);
  CHECK(table.value().rows[1].right == 1);
  CHECK(table.value().rows[1].depth == 0);
  CHECK_FALSE(table.value().rows[2].depth);
  CHECK(table.value().without_depth == 2);
}

TEST_CASE("depth images whose stamps never meet those of the camera") {
  const BagTopic left = topicAt("/l", {1'000'000'000, 1'100'000'000});
  const BagTopic depth = topicAt("/d", {1'013'000'000, 1'113'000'000});
  CHECK(makeFrameTable(left, nullptr, &depth, 5'000'000).status().message() ==
        "no image of /d has the stamp of one of /l: the nearest are 0.013000 s apart; set "
        "tolerance, or leave out depth");
  CHECK(makeFrameTable(left, nullptr, &depth, 20'000'000).value().without_depth == 0);
}

TEST_CASE("cameras whose stamps never meet") {
  const BagTopic left = topicAt("/l", {1'000'000'000});
  const BagTopic right = topicAt("/r", {1'250'000'000});
  CHECK(makeFrameTable(left, &right, nullptr, 1000).status().message() ==
        "no image of /r has the stamp of one of /l: the nearest are 0.250000 s apart; set "
        "tolerance, or mono: true");
}

}  // namespace tolman::ros_bag
