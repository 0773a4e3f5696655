// SPDX-License-Identifier: BSD-3-Clause
// Scores of units by closed forms, and walks that differ only in how they were recorded.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "evaluation/lattice_maps.hpp"
#include "evaluation/recorded_cells.hpp"

using namespace tolman;
using namespace tolman::evaluation;

TEST_CASE("sparsity of a unit that fires in one of n places is 1/n, of one that fires anywhere 1") {
  const auto one = [](const Eigen::Vector2d& at) { return at.norm() < 1 ? 3.0 : 0.0; };
  CHECK(*sparsity(test::paintedMap(8, one)) == Approx(1.0 / 64));
  CHECK(*sparsity(test::paintedMap(8, [](const auto&) { return 2.0; })) == Approx(1));
  CHECK_FALSE(sparsity(test::paintedMap(8, [](const auto&) { return 0.0; })));
}

TEST_CASE("coherence: a wide hill is coherent, stripes of one bin are the opposite") {
  const auto hill = [](const Eigen::Vector2d& at) {
    return std::exp(-(at - Eigen::Vector2d(10, 10)).squaredNorm() / 32);
  };
  CHECK(*coherence(test::paintedMap(20, hill)) > 1.5);
  const auto stripes = [](const Eigen::Vector2d& at) {
    return static_cast<int>(at.x()) % 2 == 0 ? 1.0 : 0.0;
  };
  CHECK(*coherence(test::paintedMap(20, stripes)) < -1.5);
  CHECK_FALSE(coherence(test::paintedMap(8, [](const auto&) { return 1.0; })));
}

TEST_CASE(
    "border score: 1 along one wall, -1 in the middle, the closed form along half of a wall") {
  const auto wall = [](const Eigen::Vector2d& at) { return at.x() < 1 ? 1.0 : 0.0; };
  CHECK(*borderScore(test::paintedMap(11, wall)) == Approx(1));
  const auto middle = [](const Eigen::Vector2d& at) {
    return (at - Eigen::Vector2d(5.5, 5.5)).norm() < 0.5 ? 1.0 : 0.0;
  };
  CHECK(*borderScore(test::paintedMap(11, middle)) == Approx(-1));
  // Six of eleven bins of a wall, two bins deep: c = 6/11, d = (6 * 0 + 5 * 1 + 0) / 12 / 5.
  const auto half = [](const Eigen::Vector2d& at) { return at.x() < 2 && at.y() < 6 ? 1.0 : 0.0; };
  const double c = 6.0 / 11;
  const double d = 5.0 / 12 / 5;
  CHECK(*borderScore(test::paintedMap(11, half)) == Approx((c - d) / (c + d)));
  RateMap road = test::paintedMap(11, wall);
  road.visits.bottomRows(8).setZero();
  CHECK_FALSE(borderScore(road));
}

TEST_CASE("speed score: 1 for a rate that is linear in speed, over samples that count") {
  std::vector<Sample> samples;
  for (int i = 0; i < 20; ++i) samples.push_back({{0, 0}, 0, 2 + 3.0 * i, 1, 1.0 * i});
  samples.push_back({{0, 0}, 0, 100, 0, 0});
  CHECK(*speedScore(samples) == Approx(1));
  for (Sample& sample : samples) sample.rate = -sample.rate;
  CHECK(*speedScore(samples) == Approx(-1));
  for (Sample& sample : samples) sample.rate = 1;
  CHECK_FALSE(speedScore(samples));
}

TEST_CASE("spacing, orientation and ellipticity of lattices are those that they were made with") {
  const double direction = GENERATE(0.1, 0.4, 0.9);
  const auto regular = gridScores(test::paintedMap(60, [&](const Eigen::Vector2d& at) {
    return test::latticeRate(at, 14, direction, std::numbers::pi / 3);
  }));
  REQUIRE(regular);
  CHECK(regular->spacing == Approx(14).margin(0.5));
  CHECK(regular->orientation == Approx(direction).margin(0.03));
  CHECK(regular->ellipticity == Approx(1).margin(0.04));
  const auto stretched = gridScores(test::paintedMap(60, [&](const Eigen::Vector2d& at) {
    return test::latticeRate({at.x() / 1.15, at.y()}, 14, direction, std::numbers::pi / 3);
  }));
  REQUIRE(stretched);
  CHECK(stretched->ellipticity == Approx(1.15).margin(0.05));
}

TEST_CASE("occupancy is in seconds: another frame rate in the second half changes nothing") {
  const auto bitsOf = [](int frames_of_step) {
    RecordedUnits units{{}, {{}}};
    std::vector<std::int64_t> stamps_ns;
    for (int i = 0; i < 400; ++i) {
      const int frames = i < 200 ? 1 : frames_of_step;
      for (int k = 0; k < frames; ++k) {
        const double along = 0.5 * (i + static_cast<double>(k) / frames);
        units.walk.push_back({{0.05 * std::floor(std::fmod(along, 40)), 0}});
        units.rates[0].push_back(i < 200 ? 0.5F : std::fmod(along, 40) < 10 ? 1.0F : 0.0F);
        stamps_ns.push_back(1'000'000'000LL * i + 1'000'000'000LL * k / frames);
      }
    }
    setTimes(units, stamps_ns, false);
    for (std::size_t i = 0; i < units.walk.size(); ++i) {
      units.walk[i].rate = static_cast<double>(units.rates[0][i]);
    }
    return spatialInformation(rateMap(units.walk, 20));
  };
  CHECK(bitsOf(1) > 0.05);
  CHECK(bitsOf(4) == Approx(bitsOf(1)).epsilon(0.02));
}

TEST_CASE("standing of an animal does not count, that of a car does, nor do gaps") {
  const auto secondsOf = [](double speed, double gap) {
    RecordedUnits units;
    std::vector<std::int64_t> stamps_ns;
    for (int i = 0; i < 100; ++i) {
      const int moved = std::min(i, 50);  // then it stands
      units.walk.push_back({{speed * moved, 0}});
      stamps_ns.push_back(1'000'000'000LL * i + (i > 20 ? std::llround(gap * 1e9) : 0));
    }
    setTimes(units, stamps_ns, true);
    double seconds = 0;
    for (const Sample& sample : units.walk) seconds += sample.seconds;
    return std::pair(seconds, units.speed_limit);
  };
  CHECK(secondsOf(0.2, 0) == std::pair(51.0, 0.025));
  CHECK(secondsOf(0.2, 500) == std::pair(51.0, 0.025));
  CHECK(secondsOf(12, 0) == std::pair(100.0, 0.0));
}
