// SPDX-License-Identifier: BSD-3-Clause
// Vectors of eight, in a function that exists for each kind of processor, against plain loops.
#include "eight.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::direct_sparse;

namespace {

using Floats = std::array<float, 8>;

constexpr Floats kNumbers = {1.5F, -2, 0.25F, -4.75F, 1e6F, -1e-3F, 7.999F, -0.5F};

/// What the operations make of the numbers; compiled for wide and for narrow registers.
struct Answers {
  Floats size, least, whole, joined, chosen;
  bool all_large = false, all_small = false;
};

TOLMAN_WIDE_LANES Answers answersFor(const Floats& numbers) {
  const Eight value = loadEight(numbers.data());
  const Eight size = absolute(value);
  const Eight least = smaller(value, Eight{});
  const Eight whole = toFloat(truncated(value));
  const Eight back = joined(highHalf(value), lowHalf(value));
  const Eight turned = chosen(negative(value), -value, Eight{} + 7.0F);
  Answers answers{};
  for (std::size_t k = 0; k < 8; ++k) {
    answers.size[k] = size[k];
    answers.least[k] = least[k];
    answers.whole[k] = whole[k];
    answers.joined[k] = back[k];
    answers.chosen[k] = turned[k];
  }
  answers.all_large = all(value > -10.0F);
  answers.all_small = all(value < 10.0F);
  return answers;
}

TOLMAN_WIDE_LANES void fromBytes(const std::uint8_t* a, const std::uint8_t* b, Floats& value,
                                 Floats& difference) {
  storeEight(eightBytes(a), value.data());
  storeEight(differences(a, b), difference.data());
}

/// A sum whose rounding would change if products were not rounded before they are added.
TOLMAN_WIDE_LANES float sumOfProducts(const Floats& a, const Floats& b) {
  const Eight product = loadEight(a.data()) * loadEight(b.data()) + loadEight(b.data());
  float sum = 0;
  for (std::size_t k = 0; k < 8; ++k) sum += product[k];
  return sum;
}

}  // namespace

TEST_CASE("eight bytes anywhere in memory become floats, and their differences") {
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

TEST_CASE("operations on eight lanes are those on each") {
  const Answers answers = answersFor(kNumbers);
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(answers.size[k] == std::fabs(kNumbers[k]));
    CHECK(answers.least[k] == std::min(kNumbers[k], 0.0F));
    CHECK(answers.whole[k] == std::trunc(kNumbers[k]));
    CHECK(answers.joined[k] == kNumbers[(k + 4) % 8]);
    CHECK(answers.chosen[k] == (kNumbers[k] < 0 ? -kNumbers[k] : 7));
  }
  CHECK(answers.all_large);
  CHECK_FALSE(answers.all_small);
}

TEST_CASE("whatever the processor has, products are rounded before they are added") {
  Floats a;
  Floats b;
  for (std::size_t k = 0; k < 8; ++k) {
    a[k] = 1.0F / (3.0F + static_cast<float>(k));
    b[k] = 1.0F / (7.0F - 0.3F * static_cast<float>(k));
  }
  float expected = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    const volatile float product = a[k] * b[k];
    const volatile float rounded = product + b[k];
    expected += rounded;
  }
  CHECK(sumOfProducts(a, b) == expected);
}
