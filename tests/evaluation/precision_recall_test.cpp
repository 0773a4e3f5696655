// SPDX-License-Identifier: BSD-3-Clause
// Precision and recall against closed forms, with ties, and against counts at every threshold.
#include "evaluation/precision_recall.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

PlaceClaim claim(double score, bool right) { return {0, 0, score, right}; }

}  // namespace

TEST_CASE("right claims first, then wrong ones: recall rises, then precision falls") {
  std::vector<PlaceClaim> claims;
  for (int i = 0; i < 10; ++i) claims.push_back(claim(0.01 * i, true));
  for (int i = 0; i < 10; ++i) claims.push_back(claim(0.5 + 0.01 * i, false));
  std::reverse(claims.begin(), claims.end());  // their order must not matter
  const auto curve = precisionRecall(claims, 20);
  REQUIRE(curve.size() == 20);
  for (int i = 0; i < 10; ++i) {
    CHECK(curve[std::size_t(i)].precision == 1);
    CHECK(curve[std::size_t(i)].recall == Approx((i + 1) / 20.0));
    CHECK(curve[std::size_t(i) + 10].precision == Approx(10.0 / (11 + i)));
    CHECK(curve[std::size_t(i) + 10].recall == 0.5);
  }
  CHECK(recallAt(curve, 1) == 0.5);
  CHECK(recallAt(curve, 0.5) == 0.5);
}

TEST_CASE("claims with the same score are made together") {
  // Surest first they would have precision 1, surest last 1/2: a threshold cannot tell.
  const auto curve = precisionRecall(
      {claim(0.1, true), claim(0.2, true), claim(0.2, false), claim(0.2, true), claim(0.3, true)},
      4);
  REQUIRE(curve.size() == 3);
  CHECK(curve[0].score == 0.1);
  CHECK(curve[0].claims == 1);
  CHECK(curve[1].score == 0.2);
  CHECK(curve[1].claims == 4);
  CHECK(curve[1].precision == 0.75);
  CHECK(curve[1].recall == 0.75);
  CHECK(curve[2].precision == 0.8);
  CHECK(curve[2].recall == 1);
  CHECK(recallAt(curve, 1) == 0.25);
  CHECK(recallAt(curve, 0.75) == 1);
}

TEST_CASE("recall is the largest that has the precision, even after a dip") {
  std::vector<PlaceClaim> claims = {claim(0, false)};
  for (int i = 1; i < 10; ++i) claims.push_back(claim(i, true));
  const auto curve = precisionRecall(claims, 9);
  CHECK(curve.front().precision == 0);
  CHECK(curve.front().recall == 0);
  CHECK(recallAt(curve, 0.9) == 1);
  CHECK(recallAt(curve, 0.91) == 0);
}

TEST_CASE("no claims, no right ones, nothing to be found") {
  CHECK(precisionRecall({}, 10).empty());
  CHECK(recallAt({}, 1) == 0);
  CHECK(recallAt({}, 0) == 0);
  const auto wrong = precisionRecall({claim(0.1, false), claim(0.2, false)}, 5);
  REQUIRE(wrong.size() == 2);
  CHECK(wrong[1].precision == 0);
  CHECK(recallAt(wrong, 0.01) == 0);
  const auto unfindable = precisionRecall({claim(0.1, false)}, 0);
  REQUIRE(unfindable.size() == 1);
  CHECK(unfindable[0].recall == 0);
}

TEST_CASE("every point is what counting the claims up to its score gives") {
  RandomStream random(6);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<PlaceClaim> claims;
    std::set<double> scores;
    for (int i = 0; i < 200; ++i) {
      const double score = 0.01 * static_cast<double>(random.below(40));
      claims.push_back(claim(score, random.uniform() > score));
      scores.insert(score);
    }
    const auto curve = precisionRecall(claims, 300);
    REQUIRE(curve.size() == scores.size());
    double best = 0;
    for (const PrecisionRecall& point : curve) {
      std::int64_t made = 0;
      std::int64_t right = 0;
      for (const PlaceClaim& c : claims) {
        made += c.score <= point.score ? 1 : 0;
        right += c.score <= point.score && c.right ? 1 : 0;
      }
      REQUIRE(point.claims == made);
      REQUIRE(point.precision == Approx(double(right) / double(made)));
      REQUIRE(point.recall == Approx(double(right) / 300));
      if (point.precision >= 0.7) best = std::max(best, point.recall);
    }
    CHECK(std::ranges::is_sorted(curve, std::less_equal{}, &PrecisionRecall::score));
    CHECK(recallAt(curve, 0.7) == best);
  }
}
