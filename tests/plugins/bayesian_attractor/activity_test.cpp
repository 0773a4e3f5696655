// SPDX-License-Identifier: BSD-3-Clause
// Recorded populations: tuning, fields, hypotheses and their descriptions.
#include "activity.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

std::ptrdiff_t peakOf(const std::vector<float>& rates) {
  return std::max_element(rates.begin(), rates.end()) - rates.begin();
}

}  // namespace

TEST_CASE("head direction units fire above half their peak within 45 degrees, as in the rat") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  step(plugin, motionOf({0, 0, std::numbers::pi / 2}), nothing());
  const auto ring = arrayOf(plugin, "hd.activity");
  REQUIRE(ring.size() == 36);
  CHECK(peakOf(ring) == 9);
  CHECK(ring[9] == Approx(1));
  CHECK(ring[9 + 4] > 0.5F);  // 40 degrees
  CHECK(ring[9 + 5] < 0.5F);  // 50 degrees
  CHECK(ring[9 + 18] < 0.05F);
}

TEST_CASE("each module fires at its own phase of the position") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  step(plugin, motionOf({175, 40, 0}), nothing());
  const auto first = arrayOf(plugin, "grid.activity");  // 150 m, units 5 m apart
  REQUIRE(first.size() == 900);
  CHECK(peakOf(first) == 8 * 30 + 5);
  const auto second = arrayOf(plugin, "grid2.activity");  // 213 m, units 7.1 m apart
  CHECK(peakOf(second) == 6 * 30 + 25);
  const auto decoded = arrayOf(plugin, "position.decoded");
  CHECK(decoded[0] == Approx(175));
  CHECK(decoded[1] == Approx(40));
}

TEST_CASE("hypotheses are listed with their shares, and fire by their shares") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  for (int i = 0; i < 50; ++i) step(plugin, motionOf({4, 0, 0}, i), novel(i));
  step(plugin, motionOf({4, 0, 0}, 50), measured(20));
  const auto bumps = arrayOf(plugin, "hypotheses");
  REQUIRE(bumps.size() == (kMaxBumps + 1) * 5);
  CHECK(bumps[1] == Approx(204));     // the integrator
  CHECK(bumps[5 + 1] == Approx(84));  // where template 20 was made
  CHECK(bumps[4] + bumps[5 + 4] == Approx(1));
  CHECK(bumps[4] > bumps[5 + 4]);
  CHECK(bumps[10 + 4] == 0);
}

TEST_CASE("every array is described, with its shape") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {{"modules", std::int64_t{2}}}).isOk());
  std::vector<NamedArray> arrays;
  std::vector<ArrayInfo> infos;
  plugin.arrays(arrays);
  REQUIRE(plugin.describe(infos).isOk());
  REQUIRE(arrays.size() == infos.size());
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    CHECK(arrays[i].name == infos[i].name);
    CHECK(arrays[i].shape.size() == infos[i].axes.size());
    CHECK_FALSE(infos[i].doc.empty());
  }
  CHECK(infos[2].name == "grid2.activity");
  CHECK(infos[2].axes[0].period == Approx(213));
  CHECK(infos[2].axes[0].step == Approx(7.1));
}
