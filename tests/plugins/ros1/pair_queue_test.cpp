// SPDX-License-Identifier: BSD-3-Clause
#include "pair_queue.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace tolman::ros1 {
namespace {

Arrived at(std::int64_t stamp_ns) { return {stamp_ns, {static_cast<std::uint8_t>(stamp_ns)}}; }

std::string taken(PairQueue& queue) {
  std::string text;
  while (const auto pair = queue.take()) {
    text += std::to_string(pair->left.stamp_ns) + "/" + std::to_string(pair->right.stamp_ns) + " ";
  }
  return text;
}

}  // namespace

TEST_CASE("images of one camera come as they are") {
  PairQueue queue;
  queue.addLeft(at(5));
  queue.addLeft(at(6));
  CHECK(taken(queue) == "5/0 6/0 ");
  CHECK(queue.leftOut() == 0);
}

TEST_CASE("pairs are joined within the tolerance, whichever comes first") {
  PairQueue queue(true, 3);
  queue.addRight(at(12));
  CHECK(taken(queue).empty());
  queue.addLeft(at(10));
  queue.addLeft(at(20));
  CHECK(taken(queue) == "10/12 ");
  queue.addRight(at(17));
  CHECK(taken(queue) == "20/17 ");
  CHECK(queue.leftOut() == 0);
}

TEST_CASE("an image without a partner is left out, and counted") {
  PairQueue queue(true, 3);
  for (const int stamp : {10, 20, 30, 40}) queue.addLeft(at(stamp));
  for (const int stamp : {5, 20, 41}) queue.addRight(at(stamp));
  CHECK(taken(queue) == "20/20 40/41 ");
  CHECK(queue.leftOut() == 3);  // right 5, left 10, left 30
}

TEST_CASE("a camera whose partner is silent does not fill the memory") {
  PairQueue queue(true, 3);
  for (int i = 0; i < 1000; ++i) queue.addLeft(at(i));
  CHECK(queue.leftOut() == 900);
  queue.addRight(at(998));
  const auto pair = queue.take();
  REQUIRE(pair);
  CHECK(pair->left.stamp_ns == 995);  // the oldest within the tolerance
  CHECK(pair->left.message == at(995).message);
}

}  // namespace tolman::ros1
