// SPDX-License-Identifier: BSD-3-Clause
// Statistics compared with closed forms and scipy 1.10.
#include <catch2/catch.hpp>
#include <cmath>

#include "evaluation/errors.hpp"
#include "experiment/comparison.hpp"
#include "experiment/sweep_file.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::experiment;

TEST_CASE("centre and spread") {
  const evaluation::Statistics summary = evaluation::statistics({4, 1, 3, 2});
  CHECK(summary.mean == 2.5);
  CHECK(summary.median == 2.5);
  CHECK(summary.deviation == Approx(std::sqrt(5.0 / 3)));
  CHECK(summary.min == 1);
  CHECK(summary.max == 4);
  CHECK(evaluation::quantile({1, 2, 3, 4}, 0.25) == 1.75);  // numpy.quantile([1, 2, 3, 4], 0.25)
  CHECK(evaluation::statistics({7}).deviation == 0);
}

TEST_CASE("the signed rank test is exact") {
  // All five differences positive: the two extreme ones of 2^5 signs.
  const SignedRank five = signedRank({1, 2, 3, 4, 5});
  CHECK(five.p == 2.0 / 32);
  CHECK(five.effect == 1);
  // scipy.stats.wilcoxon([0.3, -0.1, 0.8, 1.2, -0.5, 2.1, 0.9, -0.2, 1.7, 0.4],
  // mode='exact').pvalue
  CHECK(signedRank({0.3, -0.1, 0.8, 1.2, -0.5, 2.1, 0.9, -0.2, 1.7, 0.4}).p == Approx(0.048828125));
  // Rank sums 47 and 8 of those: effect (47 - 8) / 55.
  CHECK(signedRank({0.3, -0.1, 0.8, 1.2, -0.5, 2.1, 0.9, -0.2, 1.7, 0.4}).effect ==
        Approx(39.0 / 55));
  // Ties: of the eight signs of ranks 1.5, 1.5, 3 the sum is at most 1.5 in (---), (+--), (-+-).
  CHECK(signedRank({1, -1, 2}).p == Approx(2 * 3.0 / 8));
  CHECK(signedRank({0, 0, 0}).p == 1);
  CHECK(signedRank({0, 0, 3}).n == 1);
}

TEST_CASE("under the null hypothesis the test rejects as often as it says") {
  RandomStream random(11);
  int rejected = 0;
  constexpr int kTrials = 2000;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> differences;
    for (int i = 0; i < 12; ++i) differences.push_back(random.normal());
    if (signedRank(differences).p <= 0.05) ++rejected;
  }
  // P(p <= 0.05) is 0.0425 for n = 12; three standard deviations of the count are 0.0135.
  CHECK(static_cast<double>(rejected) / kTrials == Approx(0.0425).margin(0.0135));
}

TEST_CASE("the bootstrap interval is that of the mean") {
  RandomStream random(5);
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) values.push_back(3 + 2 * random.normal());
  const evaluation::Statistics summary = evaluation::statistics(values);
  const Interval interval = bootstrapMean({values}, 1);
  const double half = 1.96 * summary.deviation / std::sqrt(400);  // central limit theorem
  CHECK(interval.low == Approx(summary.mean - half).margin(0.05 * half));
  CHECK(interval.high == Approx(summary.mean + half).margin(0.05 * half));
  CHECK(bootstrapMean({values}, 1).low == interval.low);
  CHECK(bootstrapMean({values}, 2).low != interval.low);
  CHECK(bootstrapMean({{2, 2, 2}}, 1).high == 2);
}

TEST_CASE("groups that differ widen the interval of the mean") {
  // Nothing varies within: the mean of two draws of {0, 10} is 0, 5 or 10.
  const Interval interval = bootstrapMean({{0, 0, 0}, {10, 10, 10}}, 1);
  CHECK(interval.low == 0);
  CHECK(interval.high == 10);
}
