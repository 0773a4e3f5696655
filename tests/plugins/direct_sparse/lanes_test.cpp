// SPDX-License-Identifier: BSD-3-Clause
// Pixels in vectors against plain loops.
#include "lanes.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

std::vector<std::int16_t> randomShorts(std::size_t count, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<std::int16_t> values(count);
  for (std::int16_t& value : values) {
    value = static_cast<std::int16_t>(static_cast<int>(random.below(511)) - 255);
  }
  return values;
}

}  // namespace

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

TEST_CASE("the mixture of neighbours is bilinear at multiples of 1/128, with negative numbers") {
  const std::vector<std::int16_t> top = randomShorts(8, 3);
  const std::vector<std::int16_t> bottom = randomShorts(8, 4);
  for (int x = 0; x <= 128; x += 16) {
    for (int y = 0; y <= 128; y += 16) {
      const float fx = static_cast<float>(x) / 128;
      const float fy = static_cast<float>(y) / 128;
      const Four mixed = mixShorts(top.data(), bottom.data(), fx, fy);
      for (std::size_t i = 0; i < 4; ++i) {
        const float above =
            (1 - fx) * static_cast<float>(top[i]) + fx * static_cast<float>(top[i + 4]);
        const float below =
            (1 - fx) * static_cast<float>(bottom[i]) + fx * static_cast<float>(bottom[i + 4]);
        CHECK(mixed[i] == Approx((1 - fy) * above + fy * below).margin(1e-3));
      }
    }
  }
}

TEST_CASE("between the steps the mixture errs by the step times the slope at most") {
  const std::vector<std::int16_t> top = {0, 0, 0, 0, 255, 255, 255, 255};
  for (float fx = 0; fx < 1; fx += 0.013F) {
    const Four mixed = mixShorts(top.data(), top.data(), fx, 0.37F);
    CHECK(std::fabs(mixed[0] - 255 * fx) <= 255.0F / 256 + 1e-3F);
  }
}
