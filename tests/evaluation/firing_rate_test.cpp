// SPDX-License-Identifier: BSD-3-Clause
// Firing rates against closed forms.
#include "evaluation/firing_rate.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace tolman::evaluation;

namespace {

/// A square of places, each visited once.
std::vector<Sample> square(int side, double (*rate)(int x, int y)) {
  std::vector<Sample> samples;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) samples.push_back({Eigen::Vector2d(x, y), 0, rate(x, y)});
  }
  return samples;
}

template <class Rate>
std::vector<Sample> turn(Rate rate) {
  std::vector<Sample> samples;
  constexpr int kSteps = 3600;
  for (int i = 0; i < kSteps; ++i) {
    const double heading = (i + 0.5) * 2 * std::numbers::pi / kSteps - std::numbers::pi;
    samples.push_back({Eigen::Vector2d::Zero(), heading, rate(heading)});
  }
  return samples;
}

}  // namespace

TEST_CASE("a unit that fires everywhere has no spatial information") {
  const RateMap map = rateMap(square(8, [](int, int) { return 2.5; }), 7);
  CHECK(map.rate.size() == 64);
  CHECK(spatialInformation(map) == Approx(0).margin(1e-12));
  CHECK(fields(map).size() == 1);
}

TEST_CASE("a unit that fires in one of n places has log2 n bits of spatial information") {
  const RateMap map =
      rateMap(square(8, [](int x, int y) { return x == 2 && y == 3 ? 1.0 : 0.0; }), 7);
  CHECK(spatialInformation(map) == Approx(6));
  CHECK(fields(map).size() == 1);
}

TEST_CASE("fields that do not touch are counted apart, also across a corner") {
  const auto lattice = [](int x, int y) { return x % 4 == 0 && y % 4 == 0 ? 1.0 : 0.0; };
  CHECK(fields(rateMap(square(12, lattice), 11)).size() == 9);
  const auto diagonal = [](int x, int y) { return x == y ? 1.0 : 0.0; };
  CHECK(fields(rateMap(square(6, diagonal), 5)).size() == 1);
}

TEST_CASE("a field ends at a fifth of the peak, and its centre is weighted by rate") {
  const auto hill = [](int x, int y) { return y != 0 ? 0.0 : x == 1 ? 4.0 : x == 2 ? 2.0 : 0.5; };
  const auto centres = fields(rateMap(square(5, hill), 4));
  REQUIRE(centres.size() == 1);
  const auto narrow = fields(rateMap(square(5, hill), 4), 0.6);
  const auto wide = fields(rateMap(square(5, hill), 4), 0.1);
  REQUIRE((narrow.size() == 1 && wide.size() == 1));
  const double bin = narrow[0].x() / 1.5;
  CHECK(centres[0].x() == Approx(bin * (8.0 / 6 + 0.5)));
  CHECK(wide[0].x() > centres[0].x());
}

TEST_CASE("bins have the mean rate of their visits; unvisited bins have none") {
  const std::vector<Sample> samples = {{{0, 0}, 0, 1}, {{0, 0}, 0, 3}, {{10, 10}, 0, 5}};
  const RateMap map = rateMap(samples, 10);
  CHECK(map.rate(0, 0) == 2);
  CHECK(map.visits(0, 0) == 2);
  CHECK(map.rate(10, 10) == 5);
  CHECK(std::isnan(map.rate(5, 5)));
}

TEST_CASE(
    "a smoothed Gaussian field is as wide as both Gaussians together, and time is unchanged") {
  const double field = 2;  // bins
  const double kernel = 1.5;
  RateMap map;
  map.rate.resize(41, 41);
  map.visits = Eigen::MatrixXd::Constant(41, 41, 3);
  for (Eigen::Index i = 0; i < 41; ++i) {
    for (Eigen::Index j = 0; j < 41; ++j) {
      const auto square = static_cast<double>((i - 20) * (i - 20) + (j - 20) * (j - 20));
      map.rate(i, j) = std::exp(-0.5 * square / (field * field));
    }
  }
  const RateMap wide = smoothed(map, kernel);
  const double both = field * field + kernel * kernel;
  CHECK(wide.visits == map.visits);
  for (const Eigen::Index away : {0, 2, 4, 6}) {
    const double expected =
        field * field / both * std::exp(-0.5 * static_cast<double>(away * away) / both);
    CHECK_THAT(wide.rate(20 + away, 20), Catch::Matchers::WithinRel(expected, 0.02));
    CHECK_THAT(wide.rate(20, 20 - away), Catch::Matchers::WithinRel(expected, 0.02));
  }
}

TEST_CASE("smoothing weighs rates by time, and bins without visits stay without a rate") {
  RateMap map;
  map.rate = Eigen::MatrixXd::Constant(3, 1, std::numeric_limits<double>::quiet_NaN());
  map.visits = Eigen::MatrixXd::Zero(3, 1);
  map.rate(0, 0) = 4;
  map.visits(0, 0) = 1;
  map.rate(1, 0) = 1;
  map.visits(1, 0) = 3;
  const RateMap wide = smoothed(map, 1);
  const double near = std::exp(-0.5);
  CHECK_THAT(wide.rate(0, 0), Catch::Matchers::WithinRel((4 + 3 * near) / (1 + 3 * near), 1e-12));
  CHECK(std::isnan(wide.rate(2, 0)));
}

TEST_CASE("the mean vector of 1 + cos is one half, towards the crest") {
  const TuningCurve curve = tuningCurve(turn([](double h) { return 1 + std::cos(h - 1); }), 36);
  CHECK(curve.mean_vector_length == Approx(0.5).epsilon(0.01));
  CHECK(curve.preferred == Approx(1).margin(0.01));
}

TEST_CASE("a unit with one direction has mean vector length 1, one without tuning 0") {
  const auto narrow = turn([](double h) { return std::abs(h + 0.05) < 0.05 ? 1.0 : 0.0; });
  CHECK(tuningCurve(narrow, 36).mean_vector_length == Approx(1).margin(0.01));
  CHECK(tuningCurve(narrow, 36).preferred > 6);  // just below a full turn
  CHECK(tuningCurve(turn([](double) { return 1.0; }), 36).mean_vector_length ==
        Approx(0).margin(1e-9));
  CHECK(tuningCurve({}, 36).mean_vector_length == 0);
}

TEST_CASE("no samples, no map") {
  const RateMap map = rateMap({}, 10);
  CHECK(map.rate.size() == 0);
  CHECK(spatialInformation(map) == 0);
  CHECK(fields(map).empty());
}

TEST_CASE("half width at half of the peak, with unvisited headings interpolated") {
  const auto tuned = [](double h) { return std::exp(2.3665 * (std::cos(h - 2) - 1)); };
  const auto whole = tuningCurve(turn(tuned), 36).half_width;
  REQUIRE(whole);
  CHECK(*whole * kDegrees == Approx(45).margin(1));
  auto samples = turn(tuned);
  std::erase_if(samples, [](const Sample& s) { return std::abs(s.heading - 1.2) < 0.2; });
  CHECK(tuningCurve(samples, 36).half_width == Approx(*whole).margin(0.06));
  CHECK(tuningCurve(turn([](double) { return 1.0; }), 36).half_width == Approx(std::numbers::pi));
  std::erase_if(samples, [](const Sample& s) { return s.heading < 0.2; });
  CHECK_FALSE(tuningCurve(samples, 36).half_width);
}
