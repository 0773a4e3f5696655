// SPDX-License-Identifier: BSD-3-Clause
// Vectors of four against plain loops.
#include "four.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::direct_sparse;

TEST_CASE("transpose swaps rows and columns, sums adds up each vector") {
  Four rows[4];
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) rows[r][c] = static_cast<float>(10 * r + c);
  }
  const Four total = sums(rows[0], rows[1], rows[2], rows[3]);
  for (int r = 0; r < 4; ++r) CHECK(total[r] == 40.0F * static_cast<float>(r) + 6);
  transpose(rows[0], rows[1], rows[2], rows[3]);
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) CHECK(rows[r][c] == static_cast<float>(10 * c + r));
  }
}

TEST_CASE("comparisons choose lane by lane") {
  const Four a = {1, -2, 3, -4};
  const Four size = absolute(a);
  const Four least = smaller(a, four(0));
  for (int i = 0; i < 4; ++i) {
    CHECK(size[i] == std::fabs(a[i]));
    CHECK(least[i] == std::min(a[i], 0.0F));
  }
  CHECK(all(size > 0.0F));
  CHECK_FALSE(all(a > 0.0F));
}

TEST_CASE("bytes and floats are loaded from any address") {
  const std::array<std::uint8_t, 8> bytes = {0, 255, 7, 128, 9, 1, 2, 3};
  const std::array<float, 6> floats = {1, 2, 3, 4, 5, 6};
  for (std::size_t shift = 0; shift < 3; ++shift) {
    const Four fromBytes = loadBytes(bytes.data() + shift);
    const Four fromFloats = loadFour(floats.data() + shift);
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(fromBytes[i] == static_cast<float>(bytes[i + shift]));
      CHECK(fromFloats[i] == floats[i + shift]);
    }
  }
}

TEST_CASE("truncation and back keep whole parts") {
  const Four value = {0.9F, 3.0F, 117.25F, 1240.99F};
  const Four whole = toFloat(truncated(value));
  for (int i = 0; i < 4; ++i) CHECK(whole[i] == std::floor(value[i]));
}
