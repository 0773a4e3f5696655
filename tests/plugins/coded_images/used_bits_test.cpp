// SPDX-License-Identifier: BSD-3-Clause
// Images of 16 bits whose camera has fewer.
#include "used_bits.hpp"

#include <catch2/catch.hpp>

namespace tolman::source_parameters {
namespace {

/// The message after `images` images of 20000 values, of which a few are `brightest`, the others
/// `usual`.
std::string messageOf(int bits, int images, int usual, int brightest = 0, int few = 0) {
  UsedBits used(bits);
  std::string messages;
  for (int i = 0; i < images; ++i) {
    for (int k = 0; k < 20'000; ++k) {
      used.convert(static_cast<std::uint16_t>(k < few ? brightest : usual));
    }
    if (const auto finding = used.endImage("images")) messages += finding->message;
  }
  return messages;
}

}  // namespace

TEST_CASE("the 8 highest of the lowest bits become the pixel") {
  CHECK(UsedBits().convert(0x8123) == 0x81);
  CHECK(UsedBits(12).convert(0x0abc) == 0xab);
  CHECK(UsedBits(12).convert(0x1000) == 255);
  CHECK(UsedBits(8).convert(200) == 200);
}

TEST_CASE("ten images that fill at most a quarter of the range are reported once") {
  CHECK_THAT(messageOf(16, 30, 4000), Catch::Contains("stay below 4096"));
  CHECK_THAT(messageOf(16, 10, 16'000), Catch::Contains("stay below 16384"));
  CHECK(messageOf(16, 10, 17'000).empty());
  CHECK(messageOf(16, 9, 4000).empty());
  CHECK(messageOf(14, 10, 4000).find("4096") != std::string::npos);
  CHECK(messageOf(12, 10, 4000).empty());
  CHECK(messageOf(16, 10, 0).empty());  // black
}

TEST_CASE("one hot pixel in ten thousand says nothing of the others") {
  CHECK_THAT(messageOf(16, 10, 1000, 65'535, 2), Catch::Contains("stay below 1024"));
  CHECK(messageOf(16, 10, 1000, 65'535, 4).empty());
}

TEST_CASE("values beyond the bits are reported once") {
  const std::string message = messageOf(12, 30, 1000, 5000, 1);
  CHECK(message == "has values of more than 12 bits, which become white (255)");
}

TEST_CASE("images of 8 bits convert nothing, and nothing is reported") {
  UsedBits used;
  for (int i = 0; i < 30; ++i) CHECK_FALSE(used.endImage("images"));
}

}  // namespace tolman::source_parameters
