// SPDX-License-Identifier: BSD-3-Clause
// Vectors of eight, in a function that exists for each kind of processor, against plain loops.
#include "eight_floats.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::lanes;

namespace {

using Floats = std::array<float, 8>;

constexpr Floats kNumbers = {1.5F, -2, 0.25F, -4.75F, 1e6F, -1e-3F, 7.999F, -0.5F};

/// What the operations make of the numbers; compiled for wide and for narrow registers.
struct Answers {
  Floats size, least, floor, whole, joined, chosen;
  bool all_large = false, all_small = false, any_huge = false;
};

TOLMAN_WIDE_LANES Answers answersFor(const Floats& numbers) {
  const EightFloats value = loadEight(numbers.data());
  const EightFloats size = absolute(value);
  const EightFloats least = smaller(value, EightFloats{});
  const EightFloats whole = toFloat(truncated(value));
  const EightFloats floor = floorOf(value);
  const EightFloats turned = chosen(negative(value), -value, eight(7));
  const EightFloats back = joined(highHalf(value), lowHalf(value));
  Answers answers{};
  for (std::size_t k = 0; k < 8; ++k) {
    answers.size[k] = size[k];
    answers.least[k] = least[k];
    answers.floor[k] = floor[k];
    answers.whole[k] = whole[k];
    answers.joined[k] = back[k];
    answers.chosen[k] = turned[k];
  }
  answers.all_large = all(value > -10.0F);
  answers.all_small = all(value < 10.0F);
  answers.any_huge = any(value > 2e6F);
  return answers;
}

/// A sum whose rounding would change if products were not rounded before they are added.
TOLMAN_WIDE_LANES float sumOfProducts(const Floats& a, const Floats& b) {
  const EightFloats product = loadEight(a.data()) * loadEight(b.data()) + loadEight(b.data());
  float sum = 0;
  for (std::size_t k = 0; k < 8; ++k) sum += product[k];
  return sum;
}

}  // namespace

TEST_CASE("operations on eight lanes are those on each") {
  const Answers answers = answersFor(kNumbers);
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(answers.size[k] == std::fabs(kNumbers[k]));
    CHECK(answers.least[k] == std::min(kNumbers[k], 0.0F));
    CHECK(answers.floor[k] == std::floor(kNumbers[k]));
    CHECK(answers.whole[k] == std::trunc(kNumbers[k]));
    CHECK(answers.joined[k] == kNumbers[(k + 4) % 8]);
    CHECK(answers.chosen[k] == (kNumbers[k] < 0 ? -kNumbers[k] : 7));
  }
  CHECK(answers.all_large);
  CHECK_FALSE(answers.all_small);
  CHECK_FALSE(answers.any_huge);
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

TEST_CASE("a single true lane is found, wherever it is") {
  for (std::size_t k = 0; k < 8; ++k) {
    EightInts mask{};
    mask[k] = -1;
    CHECK(any(mask));
    CHECK_FALSE(all(mask));
    CHECK_FALSE(all(~mask));
  }
  CHECK_FALSE(any(EightInts{}));
  CHECK(all(~EightInts{}));
}
