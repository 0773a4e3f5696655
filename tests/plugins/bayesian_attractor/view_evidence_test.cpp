// SPDX-License-Identifier: BSD-3-Clause
// Bayes' rule for a familiar view, by hand and by counting.
#include "view_evidence.hpp"

#include <catch2/catch.hpp>
#include <numbers>
#include <tolman/context.hpp>

using namespace tolman;
using namespace tolman::bayesian_attractor;

namespace {

UncertainStep at(double x, double y, double theta, double sigma, double turn_sigma) {
  return {{x, y, theta},
          Eigen::Vector3d(sigma * sigma, sigma * sigma, turn_sigma * turn_sigma).asDiagonal()};
}

/// An out-and-back drive of n steps of one metre; the mark is the start.
PathMemory outAndBack(int n, double turn_sigma, double step_variance = 1e-4) {
  PathMemory memory(DriftSettings{0, 0});
  for (int k = 0; k < n; ++k) memory.advance({1, 0, 0}, step_variance, turn_sigma * turn_sigma);
  memory.advance({0, 0, std::numbers::pi}, 0, 0);
  for (int k = 0; k < n; ++k) memory.advance({1, 0, 0}, step_variance, turn_sigma * turn_sigma);
  memory.advance({0, 0, std::numbers::pi}, 0, 0);
  return memory;
}

}  // namespace

TEST_CASE("the odds by hand") {
  // Even prior; sigma 1 m and 0.1 rad in all; the world is 100 m by 100 m, all headings:
  // peak 1 / ((2 pi)^1.5 0.1) = 0.635, chance 1 / (1e4 2 pi).
  const ViewEvidence evidence({.prior = 0.5});
  const UncertainStep exact = at(0, 0, 0, 0, 0);
  const double peak = 1e4 / (std::sqrt(2 * std::numbers::pi) * 0.1);
  CHECK(evidence.odds(at(5, 0, 1, 1, 0.1), at(5, 0, 1, 0, 0), 1e4) == Approx(peak));
  CHECK(evidence.odds(exact, at(2, 0, 0, 1, 0.1), 1e4) == Approx(peak * std::exp(-2.0)));
  CHECK(evidence.odds(exact, at(0, 0, 0.3, 1, 0.1), 1e4) == Approx(peak * std::exp(-4.5)));
  const ViewEvidence doubtful({.prior = 0.1});
  CHECK(doubtful.odds(exact, at(0, 0, 0, 1, 0.1), 1e4) == Approx(peak / 9));
}

TEST_CASE("the odds are calibrated: of views with odds about o, o / (1 + o) are right") {
  // Right views scatter round the prediction, wrong ones lie anywhere in 60 m x 60 m.
  const ViewEvidence evidence({.prior = 0.3});
  RandomStream random(3);
  const UncertainStep predicted = at(0, 0, 0, 6, 0.5);
  int views = 0;
  int right_views = 0;
  double expected = 0;
  for (int i = 0; i < 40000; ++i) {
    const bool right = random.uniform() < 0.3;
    const UncertainStep seen =
        right ? at(6 * random.normal(), 6 * random.normal(), 0.5 * random.normal(), 0, 0)
              : at(random.uniform(-30, 30), random.uniform(-30, 30),
                   random.uniform(-std::numbers::pi, std::numbers::pi), 0, 0);
    const double odds = evidence.odds(predicted, seen, 3600);
    if (odds < 0.5 || odds > 4) continue;
    ++views;
    right_views += right ? 1 : 0;
    expected += odds / (1 + odds);
  }
  REQUIRE(views > 1000);
  CHECK(right_views / double(views) == Approx(expected / views).margin(0.03));
}

TEST_CASE("the more look-alikes, the less a view is believed; right ones restore the trust") {
  ViewEvidence evidence({.prior_views = 20});
  const PathMemory memory = outAndBack(100, 1e-3);
  CHECK(evidence.prior() == Approx(0.05));
  for (int i = 0; i < 80; ++i) evidence.judge(memory, {}, at(40, 0, 0, 1, 0.1));
  CHECK(evidence.prior() == Approx(1.0 / 100));
  CHECK(evidence.judge(memory, {}, at(0, 0, 0, 1, 0.1)) == Verdict::Decisive);
  CHECK(evidence.judge(memory, {}, at(2.5, 0, 0.1, 1, 0.1)) == Verdict::Plausible);
  for (int i = 0; i < 98; ++i) evidence.judge(memory, {}, at(0, 0, 0, 1, 0.1));
  evidence.confirm(100);
  CHECK(evidence.prior() == Approx(101.0 / 200));
  CHECK(evidence.judge(memory, {}, at(2.5, 0, 0.1, 1, 0.1)) == Verdict::Decisive);
}

TEST_CASE("sure path integration makes a view decide alone or rules it out") {
  ViewEvidence evidence({});
  const PathMemory memory = outAndBack(100, 1e-3);
  CHECK(evidence.judge(memory, {}, at(0, 0, 0, 1, 0.1)) == Verdict::Decisive);
  CHECK(evidence.judge(memory, {}, at(2, 0, 0.1, 1, 0.1)) == Verdict::Decisive);
  CHECK(evidence.judge(memory, {}, at(3.5, 0, 0.1, 1, 0.1)) == Verdict::Plausible);
  CHECK(evidence.judge(memory, {}, at(40, 0, 0, 1, 0.1)) == Verdict::RuledOut);
  CHECK(evidence.judge(memory, {}, at(0, 0, 2, 1, 0.1)) == Verdict::RuledOut);
}

TEST_CASE("unsure path integration lets no view decide alone") {
  ViewEvidence evidence({});
  const PathMemory memory = outAndBack(100, 0.1);
  CHECK(evidence.judge(memory, {}, at(0, 0, 0, 1, 0.1)) == Verdict::Plausible);
  CHECK(evidence.judge(memory, {}, at(0, 0, 1.5, 1, 0.1)) == Verdict::Plausible);
}

TEST_CASE("a false loop cannot shut out for good what dead reckoning allows") {
  ViewEvidence evidence({});
  PathMemory memory = outAndBack(100, 1e-2, 0.5);
  memory.close({}, at(30, 0, 0, 1, 0.1), 1e9);  // false: the robot is at the start
  CHECK(evidence.judge(memory, {}, at(30, 0, 0, 1, 0.1)) == Verdict::Decisive);
  CHECK(evidence.judge(memory, {}, at(0, 0, 0, 1, 0.1)) == Verdict::Plausible);
  memory.close({}, at(0, 0, 0, 1, 0.1), 16);  // the network decided for it after all
  CHECK(evidence.judge(memory, {}, at(0, 0, 0, 1, 0.1)) == Verdict::Decisive);
}
