// SPDX-License-Identifier: BSD-3-Clause
// Scores of ideal units are far above chance, those of noise at chance.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "evaluation/errors.hpp"
#include "evaluation/lattice_maps.hpp"
#include "evaluation/recorded_cells.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kArena = 40;  // m

/// A walk in straight legs that turns at random, within a square.
std::vector<Sample> walkOf(std::size_t length, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Sample> walk(1);
  walk[0].position.setConstant(kArena / 2);
  double heading = 0;
  while (walk.size() < length) {
    if (random.uniform() < 0.1) heading = random.uniform(0, kFullTurn);
    const Eigen::Vector2d next =
        walk.back().position + Eigen::Vector2d(-std::sin(heading), std::cos(heading));
    if (next.minCoeff() < 0 || next.maxCoeff() > kArena) {
      heading = random.uniform(0, kFullTurn);
      continue;
    }
    walk.push_back({next, heading, 0});
  }
  return walk;
}

template <class Rate>
RecordedUnits unitsOf(std::size_t count, Rate&& rate) {
  RecordedUnits units{walkOf(3000, 5), std::vector<std::vector<float>>(count)};
  for (std::size_t unit = 0; unit < count; ++unit) {
    for (const Sample& sample : units.walk) {
      units.rates[unit].push_back(static_cast<float>(rate(unit, sample)));
    }
  }
  return units;
}

constexpr Shuffling kShuffling{200, 100, 7};

/// Spikes of a Poisson process of one rate.
RecordedUnits noise(std::size_t count) {
  RandomStream random(11);
  return unitsOf(count, [&](std::size_t, const Sample&) {
    int spikes = 0;
    for (double left = random.uniform(); left > std::exp(-0.5); left *= random.uniform()) ++spikes;
    return spikes;
  });
}

}  // namespace

TEST_CASE("an ideal von Mises ring: width and vector of the closed form, all above chance") {
  constexpr double kConcentration = 2.3665;  // half of the peak at 45 degrees
  const PopulationScores scores = scoreRing(
      unitsOf(12,
              [&](std::size_t unit, const Sample& sample) {
                const double off = sample.heading - static_cast<double>(unit) * kFullTurn / 12;
                return std::exp(kConcentration * (std::cos(off) - 1));
              }),
      kShuffling);
  REQUIRE(scores.of("half_width_deg"));
  CHECK(scores.of("half_width_deg")->median == Approx(45).margin(2));
  REQUIRE(scores.units.size() == 12);
  for (const MeasuredUnit& unit : scores.units) {
    CHECK(*unit.tuning.half_width * kDegrees == Approx(45).margin(4));
  }
  // I1/I0 of the concentration.
  REQUIRE(scores.of("mean_vector_length"));
  CHECK(scores.of("mean_vector_length")->median ==
        Approx(std::cyl_bessel_i(1, kConcentration) / std::cyl_bessel_i(0, kConcentration))
            .margin(0.02));
  CHECK(scores.of("mean_vector_length")->chance < 0.5);
  CHECK(scores.of("mean_vector_length")->share_better == 1);
}

TEST_CASE("ideal grids score above chance by their own definition") {
  const double angle = GENERATE(std::numbers::pi / 3, std::numbers::pi / 2);
  const bool hexagonal = angle < 1.2;
  const PopulationScores scores = scoreSheet(
      unitsOf(8,
              [&](std::size_t unit, const Sample& sample) {
                const Eigen::Vector2d phase = Eigen::Vector2d(3, 5) * static_cast<double>(unit);
                return test::latticeRate(sample.position + phase, 12, 0.2, angle);
              }),
      12, kShuffling);
  REQUIRE((scores.of("grid_score_square") && scores.of("grid_score_sargolini") &&
           scores.of("grid_score_langston") && scores.of("spatial_information_bits")));
  const UnitScore& own =
      hexagonal ? *scores.of("grid_score_sargolini") : *scores.of("grid_score_square");
  const UnitScore& other =
      hexagonal ? *scores.of("grid_score_square") : *scores.of("grid_score_sargolini");
  CHECK(own.median > 0.9);
  CHECK(own.share_better == 1);
  REQUIRE(scores.units.size() == 8);
  for (const MeasuredUnit& unit : scores.units) {
    CHECK(*unit.scores[scores.indexOf("spacing_m")] == Approx(12).margin(1.5));
    CHECK(unit.fields >= 6);
  }
  CHECK(own.chance < 0.9);
  CHECK(own.shuffled_median < 0.3);
  CHECK(other.median < 0.3);
  CHECK(scores.of("spatial_information_bits")->share_better == 1);
}

TEST_CASE("of Poisson noise about a twentieth is above chance") {
  const RecordedUnits units = noise(100);
  const PopulationScores ring = scoreRing(units, kShuffling);
  const PopulationScores sheet = scoreSheet(units, 12, kShuffling);
  for (const auto& score :
       {ring.of("mean_vector_length"), ring.of("spatial_information_bits"),
        ring.of("half_width_deg"), sheet.of("grid_score_square"), sheet.of("grid_score_sargolini"),
        sheet.of("grid_score_langston"), sheet.of("spatial_information_bits")}) {
    REQUIRE(score);
    CHECK(score->share_better < 0.13);  // four standard deviations of 100 units at 5 %
  }
  CHECK(ring.of("mean_vector_length")->median ==
        Approx(ring.of("mean_vector_length")->shuffled_median).epsilon(0.25));
}

TEST_CASE("the same seed gives the same chance") {
  const RecordedUnits units = noise(10);
  const auto bits = [&](std::uint64_t seed) {
    return scoreRing(units, {200, 100, seed}).of("spatial_information_bits")->chance;
  };
  CHECK(bits(1) == bits(1));
  CHECK(bits(1) != bits(2));
}

TEST_CASE("percentiles by hand") {
  const Statistics errors = statistics({5, 1, 4, 2, 3});
  CHECK(errors.count == 5);
  CHECK(errors.median == 3);
  CHECK(errors.p90 == Approx(4.6));
  std::vector<double> shuffled;
  for (int i = 0; i <= 100; ++i) shuffled.push_back(i);
  const auto score = againstChance({94, 96, 97, 99}, shuffled);
  REQUIRE(score);
  CHECK(score->chance == Approx(95));
  CHECK(score->shuffled_median == 50);
  CHECK(score->share_better == 0.75);
  CHECK(againstChance({4, 6}, shuffled, Better::Less)->share_better == 0.5);
  CHECK_FALSE(againstChance({}, shuffled));
  CHECK_FALSE(againstChance({1}, {}));
}

TEST_CASE("a walk of few headings, or too short to shift, has no such score") {
  RecordedUnits street{{}, {{}}};
  for (int i = 0; i < 300; ++i) {
    street.walk.push_back({{0, i}, 0.1, 0});
    street.rates[0].push_back(static_cast<float>(i % 7));
  }
  const PopulationScores scores = scoreRing(street, kShuffling);
  CHECK_FALSE(scores.of("mean_vector_length"));
  CHECK_FALSE(scores.of("half_width_deg"));
  CHECK(scores.of("spatial_information_bits"));
  CHECK_FALSE(scoreSheet(street, 12, kShuffling).of("grid_score_square"));
  CHECK_FALSE(scoreRing(street, {200, 151, 1}).of("spatial_information_bits"));
  CHECK_FALSE(scoreRing({}, kShuffling).of("spatial_information_bits"));
}
