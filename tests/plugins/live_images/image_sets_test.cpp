// SPDX-License-Identifier: BSD-3-Clause
#include "image_sets.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace tolman::live_images {
namespace {

Arrived at(std::int64_t stamp_ns) { return {stamp_ns, {static_cast<std::uint8_t>(stamp_ns)}}; }

std::string taken(ImageSets& sets) {
  std::string text;
  while (const auto set = sets.take()) {
    for (const Arrived& image : *set) {
      text += (&image == &set->front() ? "" : "/") + std::to_string(image.stamp_ns);
    }
    text += " ";
  }
  return text;
}

}  // namespace

TEST_CASE("images of one camera come as they are") {
  ImageSets queue;
  queue.add(0, at(5));
  queue.add(0, at(6));
  CHECK(taken(queue) == "5 6 ");
  CHECK(queue.leftOut() == 0);
}

TEST_CASE("pairs are joined within the tolerance, whichever comes first") {
  ImageSets queue(2, 3);
  queue.add(1, at(12));
  CHECK(taken(queue).empty());
  queue.add(0, at(10));
  queue.add(0, at(20));
  CHECK(taken(queue) == "10/12 ");
  queue.add(1, at(17));
  CHECK(taken(queue) == "20/17 ");
  CHECK(queue.leftOut() == 0);
}

TEST_CASE("an image without a partner is left out, and counted") {
  ImageSets queue(2, 3);
  for (const int stamp : {10, 20, 30, 40}) queue.add(0, at(stamp));
  for (const int stamp : {5, 20, 41}) queue.add(1, at(stamp));
  CHECK(taken(queue) == "20/20 40/41 ");
  CHECK(queue.leftOut() == 3);  // right 5, left 10, left 30
}

TEST_CASE("a camera whose partner is silent does not fill the memory") {
  ImageSets queue(2, 3);
  for (int i = 0; i < 1000; ++i) queue.add(0, at(i));
  CHECK(queue.leftOut() == 900);
  queue.add(1, at(998));
  const auto pair = queue.take();
  REQUIRE(pair);
  CHECK(pair->front().stamp_ns == 995);  // the oldest within the tolerance
  CHECK(pair->front().message == at(995).message);
}

TEST_CASE("three cameras: all of them within the tolerance of the first") {
  ImageSets queue(3, 3);
  for (const int stamp : {10, 20, 30}) queue.add(0, at(stamp));
  for (const int stamp : {12, 22, 31}) queue.add(1, at(stamp));
  for (const int stamp : {8, 30}) queue.add(2, at(stamp));
  CHECK(taken(queue) == "10/12/8 30/31/30 ");
  CHECK(queue.leftOut() == 2);
}

}  // namespace tolman::live_images
