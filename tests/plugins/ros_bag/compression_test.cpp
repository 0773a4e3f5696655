// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "bag_case.hpp"
#include "file_bytes.hpp"

namespace tolman::ros_bag {

TEST_CASE("Zstandard frames are unpacked whole or not at all") {
  std::string text;
  for (int i = 0; i < 50'000; ++i) text += static_cast<char>(i % 251 * (i % 241) % 239);
  const std::string packed = test::packedByZstd(text);
  CHECK(isZstd(asBytes(packed)));
  CHECK_FALSE(isZstd(asBytes(text)));
  const auto unpacked = unpackZstd(asBytes(packed), text.size());
  REQUIRE(unpacked);
  CHECK(std::string(unpacked->begin(), unpacked->end()) == text);
  CHECK_FALSE(unpackZstd(asBytes(packed), text.size() - 1));
  CHECK_FALSE(unpackZstd(asBytes(packed).first(packed.size() / 2), text.size()));
  CHECK_FALSE(unpackZstd({}, 100));
  const auto twice = unpackZstd(asBytes(packed + packed), 2 * text.size());
  REQUIRE(twice);
  CHECK(twice->size() == 2 * text.size());
}

TEST_CASE("a small frame that unpacks to much is stopped at the limit") {
  const std::string bomb = test::packedByZstd(std::string(std::size_t{64} << 20U, '\0'));
  CHECK(bomb.size() < 100'000);
  CHECK_FALSE(unpackZstd(asBytes(bomb), 1U << 20U));
}

TEST_CASE("what is no LZ4 frame") {
  CHECK_FALSE(unpackLz4({}, 100));
  CHECK_FALSE(unpackLz4(asBytes("no frame at all, only text"), 100));
}

}  // namespace tolman::ros_bag
