// SPDX-License-Identifier: BSD-3-Clause
// Memory in large pages can be written and read.
#include "large_pages.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <numeric>
#include <vector>

using namespace tolman::direct_sparse;

TEST_CASE("a vector in large pages begins at a page and keeps what is put into it") {
  for (const std::size_t count : {std::size_t{1}, std::size_t{3'000'000}}) {
    std::vector<std::int16_t, LargePages<std::int16_t>> numbers(count);
    CHECK(reinterpret_cast<std::uintptr_t>(numbers.data()) % (2U << 20U) == 0);
    std::iota(numbers.begin(), numbers.end(), std::int16_t{0});
    const auto copy = numbers;
    CHECK(copy.data() != numbers.data());
    CHECK(copy == numbers);
    CHECK(copy.back() == static_cast<std::int16_t>(count - 1));
  }
}
