// SPDX-License-Identifier: BSD-3-Clause
// Costs of a row search against a plain loop.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <vector>

#include "row_alignment.hpp"
#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

TEST_CASE("costs are sums of absolute differences, for any length and place of the row") {
  const GrayLevel image =
      test::levelOf(120, 24, [](int u, int v) { return (u * u * 37 + v * 91 + u * v * 5) % 256; });
  StereoPatch patch{};
  for (std::size_t i = 0; i < patch.size(); ++i) {
    patch[i] = static_cast<std::uint8_t>(i * i * 53 % 256);
  }
  for (const int v : {5, 11, 18}) {
    for (const int begin : {5, 6, 37}) {
      for (const int count : {1, 7, 8, 9, 30, 78}) {
        std::vector<std::uint16_t> costs(std::size_t(count + kMoreCosts));
        rowCosts(patch, image, begin, begin + count, v, costs.data());
        for (int i = 0; i < count; ++i) {
          int sum = 0;
          for (int y = 0; y < kPatchHeight; ++y) {
            for (int x = 0; x < kPatchWidth; ++x) {
              const int there = image.row(v + y - 2)[begin + i + x - 4];
              sum += std::abs(there - patch[std::size_t(y * kPatchWidth + x)]);
            }
          }
          CAPTURE(v, begin, count, i);
          CHECK(costs[std::size_t(i)] == sum);
        }
      }
    }
  }
}

TEST_CASE("the largest cost, black against white, fits") {
  const GrayLevel white = test::levelOf(60, 24, [](int, int) { return 255; });
  std::vector<std::uint16_t> costs(20 + kMoreCosts);
  rowCosts(StereoPatch{}, white, 10, 30, 12, costs.data());
  for (std::size_t i = 0; i < 20; ++i) CHECK(costs[i] == 40 * 255);
}
