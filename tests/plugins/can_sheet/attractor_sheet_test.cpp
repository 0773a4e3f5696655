// SPDX-License-Identifier: BSD-3-Clause
// The network of one module against the paper's equations, summed unit by unit.
#include "attractor_sheet.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::can_sheet;

namespace {

/// Distance of the paper: the least of seven images of a unit, given in the plane.
double imageDistance(const Eigen::Vector2d& difference) {
  const double h = std::sqrt(3.0) / 2;
  double least = 1e9;
  for (const auto& [x, y] : std::vector<std::pair<double, double>>{
           {0, 0}, {-0.5, h}, {-0.5, -h}, {0.5, h}, {0.5, -h}, {-1, 0}, {1, 0}}) {
    least = std::min(least, (difference + Eigen::Vector2d(x, y)).norm());
  }
  return least;
}

/// Units of a rhombus in the plane.
Eigen::Vector2d unitAt(std::size_t i, std::size_t n) {
  const double u = static_cast<double>(i % n) / static_cast<double>(n);
  const double v = static_cast<double>(i / n) / static_cast<double>(n);
  return {u + v / 2, v * std::sqrt(3.0) / 2};
}

/// Moves a point by lattice vectors until it is within the hexagon round 0.
Eigen::Vector2d reduced(Eigen::Vector2d point) {
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 6; ++k) {
      const Eigen::Vector2d corner(std::cos(k * std::numbers::pi / 3),
                                   std::sin(k * std::numbers::pi / 3));
      if ((point - corner).norm() < point.norm() - 1e-12) point -= corner;
    }
  }
  return point;
}

std::vector<double> oneStep(const std::vector<double>& rates, std::size_t n,
                            const Eigen::Vector2d& moved) {
  const double total = std::accumulate(rates.begin(), rates.end(), 0.0);
  const double scale = 90.0 / static_cast<double>(n * n);
  std::vector<double> next(rates.size());
  for (std::size_t i = 0; i < rates.size(); ++i) {
    double input = 0;
    for (std::size_t j = 0; j < rates.size(); ++j) {
      const double d = imageDistance(reduced(unitAt(i, n) - unitAt(j, n) - moved));
      input += rates[j] * scale * (0.3 * std::exp(-d * d / (0.24 * 0.24)) - 0.05);
    }
    next[i] = std::max(0.0, 0.2 * input + 0.8 * input / total);
  }
  return next;
}

double phaseError(const AttractorSheet& sheet, const Phase& expected) {
  return shortest(sheet.phase() - expected).norm();
}

}  // namespace

TEST_CASE("a step is that of the equations, for sizes with and without a rest of the tiles") {
  for (const int n : {9, 20, 23}) {
    AttractorSheet sheet({.units = n});
    const Phase motion(0.07, -0.31);
    std::vector<double> rates(sheet.activity().begin(), sheet.activity().end());
    sheet.step(motion);
    const auto expected = oneStep(rates, static_cast<std::size_t>(n), toPlane(motion));
    const double peak = *std::max_element(expected.begin(), expected.end());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      REQUIRE(static_cast<double>(sheet.activity()[i]) == Approx(expected[i]).margin(1e-4 * peak));
    }
  }
}

TEST_CASE("phases and displacements are inverse, and shortest ways are those of the seven images") {
  RandomStream random(3);
  for (int i = 0; i < 500; ++i) {
    const Phase phase(random.uniform(-2, 2), random.uniform(-2, 2));
    CHECK((toPhase(toPlane(phase)) - phase).norm() < 1e-12);
    CHECK(shortest(phase).norm() == Approx(imageDistance(reduced(toPlane(phase)))).margin(1e-9));
  }
}

TEST_CASE("the bump follows steps of any length") {
  const double step = GENERATE(0.004, 0.03, 0.2, 0.9);
  AttractorSheet sheet({.units = 40});
  RandomStream random(7);
  Phase place = Phase::Zero();
  double worst = 0;
  double heading = 0;
  for (int i = 0; i < 200; ++i) {
    heading += random.uniform(-0.4, 0.4);
    const Phase motion = toPhase(step * Eigen::Vector2d(std::cos(heading), std::sin(heading)));
    sheet.step(motion);
    place += motion;
    worst = std::max(worst, phaseError(sheet, place));
  }
  CHECK(worst < 0.01);
}

TEST_CASE("the activity stays one bump of the same height and size") {
  AttractorSheet sheet({.units = 30});
  const double before = std::accumulate(sheet.activity().begin(), sheet.activity().end(), 0.0);
  for (int i = 0; i < 300; ++i) sheet.step(Phase(0.011, 0.005));
  const double after = std::accumulate(sheet.activity().begin(), sheet.activity().end(), 0.0);
  CHECK(after == Approx(before).epsilon(0.01));
}

TEST_CASE("injection near the bump draws it, far from it dies out, and a strong one wins") {
  AttractorSheet near({.units = 24});
  near.inject(Phase(0.1, 0), 0.3);
  for (int i = 0; i < 30; ++i) near.step(Phase::Zero());
  CHECK(near.phase().x() > 0.01);
  CHECK(near.phase().x() < 0.1);
  AttractorSheet far({.units = 24});
  far.inject(Phase(1.0 / 3, 1.0 / 3), 0.1);
  for (int i = 0; i < 60; ++i) far.step(Phase::Zero());
  CHECK(phaseError(far, Phase::Zero()) < 0.02);
  AttractorSheet strong({.units = 24});
  strong.inject(Phase(1.0 / 3, 1.0 / 3), 3);
  for (int i = 0; i < 60; ++i) strong.step(Phase::Zero());
  CHECK(phaseError(strong, Phase(1.0 / 3, 1.0 / 3)) < 0.02);
}

TEST_CASE("activity that cannot be is not restored, and dead activity starts again") {
  AttractorSheet sheet({.units = 8});
  std::vector<float> rates(64, 0.0F);
  CHECK_FALSE(sheet.restore(rates));
  rates[3] = -1;
  CHECK_FALSE(sheet.restore(rates));
  CHECK_FALSE(sheet.restore(std::vector<float>(63, 1.0F)));
  rates[3] = 1;
  CHECK(sheet.restore(rates));
  AttractorSheet dying({.units = 8, .intensity = 0.05, .inhibition = 10});
  dying.step(Phase(0.25, 0));
  CHECK(*std::max_element(dying.activity().begin(), dying.activity().end()) > 0);
}
