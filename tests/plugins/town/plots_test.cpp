// SPDX-License-Identifier: BSD-3-Clause
// Ground plans: overlap compared with point sampling, and refused plots.
#include "plots.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "small_town.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

bool contains(const Plot& plot, const Eigen::Vector2d& p) {
  const Eigen::Vector2d d = p - plot.centre;
  return std::abs(d.dot(plot.axis)) <= plot.half_length &&
         std::abs(d.dot(plot.across())) <= plot.half_depth;
}

/// Whether any of many points of `a` lies in `b`.
bool overlapBySampling(const Plot& a, const Plot& b) {
  constexpr int kSteps = 60;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const double along = a.half_length * (2.0 * i / kSteps - 1);
      const double over = a.half_depth * (2.0 * j / kSteps - 1);
      if (contains(b, a.point(along, over))) return true;
    }
  }
  return false;
}

Plot randomPlot(RandomStream& random) {
  const double angle = random.uniform(0, 7);
  return {{random.uniform(-6, 6), random.uniform(-6, 6)},
          {std::cos(angle), std::sin(angle)},
          random.uniform(0.5, 4),
          random.uniform(0.5, 4)};
}

}  // namespace

TEST_CASE("overlap of rectangles agrees with sampling") {
  RandomStream random(11);
  int apart = 0;
  for (int i = 0; i < 1500; ++i) {
    const Plot a = randomPlot(random);
    const Plot b = randomPlot(random);
    const bool sampled = overlapBySampling(a, b) || overlapBySampling(b, a);
    REQUIRE(overlap(a, b) == overlap(b, a));
    if (sampled) REQUIRE(overlap(a, b));
    // What sampling misses is a sliver: shrunk a little, the plots are apart.
    Plot smaller = a;
    smaller.half_length *= 0.9;
    smaller.half_depth *= 0.9;
    if (!sampled) REQUIRE_FALSE(overlap(smaller, b));
    apart += !sampled;
  }
  CHECK(apart > 200);
  CHECK(apart < 1300);
}

TEST_CASE("the book keeps plots apart and streets free") {
  const town::test::SmallTown town;
  PlotBook book(town.plan);
  const StreetPoint& on_street = town.plan.sections().front().points[20];
  Plot plot;
  plot.half_length = plot.half_depth = 2;
  plot.centre = on_street.position;
  CHECK_FALSE(book.enter(plot, 3));
  const Eigen::Vector2d left(-on_street.direction.y(), on_street.direction.x());
  plot.axis = on_street.direction;
  plot.centre = on_street.position + 9 * left;
  CHECK(book.enter(plot, 3));
  CHECK_FALSE(book.enter(plot, 3));  // taken
  plot.centre += 2.5 * on_street.direction;
  CHECK_FALSE(book.enter(plot, 3));  // partly taken
  plot.centre += 2.5 * on_street.direction;
  CHECK(book.enter(plot, 3));
}
