// SPDX-License-Identifier: BSD-3-Clause
// Pixels in vectors against plain loops.
#include "lanes.hpp"

#include <array>
#include <catch2/catch.hpp>

using namespace tolman::direct_sparse;

namespace {

using Floats = std::array<float, 8>;

TOLMAN_WIDE_LANES void fromBytes(const std::uint8_t* a, const std::uint8_t* b, Floats& value,
                                 Floats& difference) {
  store(eightBytes(a), value.data());
  store(differences(a, b), difference.data());
}

}  // namespace

TEST_CASE("bytes and floats are loaded from any address") {
  const std::array<std::uint8_t, 8> bytes = {0, 255, 7, 128, 9, 1, 2, 3};
  const std::array<float, 6> floats = {1, 2, 3, 4, 5, 6};
  for (std::size_t shift = 0; shift < 3; ++shift) {
    const Four four_bytes = loadBytes(bytes.data() + shift);
    const Four four_floats = loadFour(floats.data() + shift);
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(four_bytes[i] == static_cast<float>(bytes[i + shift]));
      CHECK(four_floats[i] == floats[i + shift]);
    }
  }
}

TEST_CASE("eight bytes and their differences, from any address") {
  std::array<std::uint8_t, 40> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 97 + 200);
  for (std::size_t first = 0; first < 16; ++first) {
    Floats value{};
    Floats difference{};
    fromBytes(bytes.data() + first, bytes.data() + 2 * first + 1, value, difference);
    for (std::size_t k = 0; k < 8; ++k) {
      CHECK(value[k] == static_cast<float>(bytes[first + k]));
      CHECK(difference[k] == static_cast<float>(bytes[first + k] - bytes[2 * first + 1 + k]));
    }
  }
}
