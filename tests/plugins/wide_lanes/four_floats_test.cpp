// SPDX-License-Identifier: BSD-3-Clause
// Vectors of four against plain loops.
#include "four_floats.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::lanes;

TEST_CASE("transpose swaps rows and columns, sums adds up each vector") {
  FourFloats rows[4];
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) rows[r][c] = static_cast<float>(10 * r + c);
  }
  const FourFloats total = sums(rows[0], rows[1], rows[2], rows[3]);
  for (int r = 0; r < 4; ++r) CHECK(total[r] == 40.0F * static_cast<float>(r) + 6);
  transpose(rows[0], rows[1], rows[2], rows[3]);
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) CHECK(rows[r][c] == static_cast<float>(10 * c + r));
  }
}

TEST_CASE("comparisons choose lane by lane") {
  const FourFloats a = {1, -2, 3, -4};
  const FourFloats size = absolute(a);
  const FourFloats least = smaller(a, four(0));
  for (int i = 0; i < 4; ++i) {
    CHECK(size[i] == std::fabs(a[i]));
    CHECK(least[i] == std::min(a[i], 0.0F));
  }
  CHECK(all(size > 0.0F));
  CHECK_FALSE(all(a > 0.0F));
  CHECK(any(a > 2.0F));
  CHECK_FALSE(any(a > 3.0F));
}

TEST_CASE("truncation and back keep whole parts") {
  const FourFloats value = {0.9F, 3.0F, 117.25F, 1240.99F};
  const FourFloats whole = toFloat(truncated(value));
  for (int i = 0; i < 4; ++i) CHECK(whole[i] == std::floor(value[i]));
}
