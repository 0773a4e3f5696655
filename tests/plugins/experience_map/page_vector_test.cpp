// SPDX-License-Identifier: BSD-3-Clause
#include "page_vector.hpp"

#include <Eigen/Core>
#include <catch2/catch.hpp>
#include <numeric>

#include "growing_list.hpp"

namespace tolman::experience_map {

TEST_CASE("a vector keeps its values while it grows from the heap into pages of its own") {
  PageVector<int> numbers;
  for (int i = 0; i < 1'000'000; ++i) numbers.push_back(i);
  std::vector<int> expected(numbers.size());
  std::iota(expected.begin(), expected.end(), 0);
  CHECK(std::equal(numbers.begin(), numbers.end(), expected.begin(), expected.end()));
  const PageVector<int> copy = numbers;
  numbers.clear();
  numbers.shrink_to_fit();
  CHECK(copy.size() == expected.size());
  CHECK(copy.back() == 999'999);
}

TEST_CASE("matrices in pages and in growing lists are aligned as Eigen needs them") {
  using Block = Eigen::Matrix<double, 6, 6>;
  PageVector<Block> blocks;
  GrowingList<Block> list;
  for (int i = 0; i < 2000; ++i) {
    blocks.push_back(Block::Constant(i));
    list.push_back(Block::Constant(i));
    REQUIRE(reinterpret_cast<std::uintptr_t>(&blocks.back()) % alignof(Block) == 0);
    REQUIRE(reinterpret_cast<std::uintptr_t>(&list.back()) % alignof(Block) == 0);
  }
  CHECK(blocks[1234] == Block::Constant(1234));
  CHECK(list[1234] == Block::Constant(1234));
}

}  // namespace tolman::experience_map
