// SPDX-License-Identifier: BSD-3-Clause
// Four doubles, in a function that exists for each kind of processor, against plain loops.
#include "four_doubles.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::lanes;

namespace {

using Doubles = std::array<double, 4>;

struct DoubleAnswers {
  Doubles root, chosen;
  double sum = 0;
};

TOLMAN_WIDE_LANES DoubleAnswers doublesFor(const Doubles& numbers) {
  Fours<2> values;
  for (std::size_t k = 0; k < 4; ++k) values[0][k] = numbers[k];
  values[1] = select(values[0] > 2.0, values[0], four(-1.0));
  const FourDoubles root = squareRoot(values[0]);
  DoubleAnswers answers{};
  for (std::size_t k = 0; k < 4; ++k) {
    answers.root[k] = root[k];
    answers.chosen[k] = values[1][k];
  }
  answers.sum = sumOf(values[0]);
  return answers;
}

}  // namespace

TEST_CASE("operations on four doubles are those on each") {
  const Doubles numbers = {1.25, 2.5, 1e300, 0};
  const DoubleAnswers answers = doublesFor(numbers);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(answers.root[k] == std::sqrt(numbers[k]));
    CHECK(answers.chosen[k] == (numbers[k] > 2 ? numbers[k] : -1));
  }
  CHECK(answers.sum == (1.25 + 2.5) + 1e300);
}
