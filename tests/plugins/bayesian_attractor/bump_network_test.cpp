// SPDX-License-Identifier: BSD-3-Clause
// Energies of hypotheses, calculated by hand, and their competition.
#include "bump_network.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;

namespace {

const Eigen::Matrix3d kReported = Eigen::Vector3d(4e-4, 4e-4, 4e-6).asDiagonal();
const Eigen::Matrix3d kMeasured = Eigen::Vector3d(0.09, 0.09, 9e-4).asDiagonal();

void drive(BumpNetwork& network, int steps, double turn = 0) {
  for (int i = 0; i < steps; ++i) network.integrate({1, 0, turn}, kReported);
}

const CalibrationBump& strongest(const BumpNetwork& network) {
  const auto& bumps = network.state().calibration;
  REQUIRE_FALSE(bumps.empty());
  return *std::ranges::max_element(bumps, {}, &CalibrationBump::energy);
}

double logit(double share) { return std::log(share / (1 - share)); }

}  // namespace

TEST_CASE(
    "the energy of a new bump is prior log odds plus log-likelihood ratio against look-alikes") {
  BumpNetwork network({.recalibrate = false});  // no steady errors
  const LearnedPattern start = network.currentPattern();
  drive(network, 200);
  // According to the view the robot is 60 m behind the place that path integration gives.
  const Recalibration calibrated = network.inject(start, {140, 0, 0}, kMeasured);
  CHECK_FALSE(calibrated.accepted);

  // By hand: the covariance of a straight way of n steps.
  const NetworkSettings s;
  const double n = 200;
  const double turn = 4e-6 + s.drift_heading * s.drift_heading;
  const double slip = 4e-4 + s.drift_position * s.drift_position;
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  S(0, 0) = n * slip;
  S(1, 1) = n * slip + turn * (n - 1) * n * (2 * n - 1) / 6;
  S(1, 2) = S(2, 1) = turn * (n - 1) * n / 2;
  S(2, 2) = n * turn;
  S += kMeasured + network.code().readout();
  const Eigen::Vector3d off(-60, 0, 0);
  const double q = off.dot(S.inverse() * off);
  const double density = std::lgamma(3.5) - std::lgamma(2) - 1.5 * std::log(4 * std::numbers::pi) -
                         0.5 * std::log(S.determinant()) - 3.5 * std::log1p(q / 4);
  const double area = (200 + 40) * 40;
  const double look_alike = -std::log(2 * std::numbers::pi * std::max(area, 1e4));
  const double expected = logit(0.05 * 100 / 101) + density - look_alike;
  CHECK(strongest(network).energy == Approx(expected).epsilon(1e-6));
  CHECK(network.share(expected) == Approx(1 / (1 + std::exp(-expected))));
}

TEST_CASE(
    "one view where path integration expects it is accepted, and the integrator moves to it") {
  BumpNetwork network({});
  const LearnedPattern start = network.currentPattern();
  for (int side = 0; side < 4; ++side) {
    drive(network, 99);
    network.integrate({1, 0, std::numbers::pi / 2}, kReported);
  }
  const Recalibration calibrated = network.inject(start, {0.5, 0.2, 0.02}, kMeasured);
  REQUIRE(calibrated.accepted);
  CHECK(calibrated.share > 0.98);
  CHECK(calibrated.views == 1);
  CHECK(calibrated.bump == 0);
  const Eigen::Vector3d here =
      network.code().difference(start.pattern, network.state().integrator.centre);
  CHECK(here.x() == Approx(0.5));
  CHECK(here.y() == Approx(0.2));
  CHECK(network.state().calibration.empty());
}

TEST_CASE("energies add up: several agreeing views far from path integration are accepted") {
  BumpNetwork network({});
  std::vector<LearnedPattern> seen;
  for (int i = 0; i < 400; ++i) {  // once round a circle
    seen.push_back(network.currentPattern());
    drive(network, 1, 2 * std::numbers::pi / 400);
  }
  // The truth: path integration is 20 m behind.
  int views = 0;
  bool accepted = false;
  for (std::size_t place = 20; !accepted && views < 20; place += 5, ++views) {
    accepted = network.inject(seen[place], {}, kMeasured).accepted;
    drive(network, 5, 2 * std::numbers::pi / 400);
  }
  CHECK(accepted);
  CHECK(views > 1);
  CHECK(views < 8);
}

TEST_CASE("views that contradict each other make separate bumps, never an average") {
  BumpNetwork network({});
  std::vector<LearnedPattern> seen;
  for (int i = 0; i < 600; ++i) {
    seen.push_back(network.currentPattern());
    drive(network, 1, 0.01);
  }
  RandomStream random(2);
  for (int i = 0; i < 100; ++i) {
    drive(network, 5);
    CHECK_FALSE(network.inject(seen[random.below(400)], {}, kMeasured).accepted);
    CHECK(network.state().calibration.size() <= kMaxBumps);
  }
}

TEST_CASE("a view repeated without motion adds no energy") {
  BumpNetwork network({});
  const LearnedPattern start = network.currentPattern();
  drive(network, 300);
  network.inject(start, {250, 30, 0}, kMeasured);
  const double once = strongest(network).energy;
  for (int i = 0; i < 20; ++i) CHECK_FALSE(network.inject(start, {250, 30, 0}, kMeasured).accepted);
  CHECK(strongest(network).energy == once);
}

TEST_CASE("a bump loses energy in proportion to the driven distance and is removed") {
  BumpNetwork network({});
  const LearnedPattern start = network.currentPattern();
  drive(network, 100);
  network.inject(start, {94, 0, 0}, kMeasured);
  const double before = strongest(network).energy;
  drive(network, 50);
  CHECK(strongest(network).energy == Approx(before - 50 * NetworkSettings{}.inhibition));
  drive(network, 2000);
  CHECK(network.state().calibration.empty());
}

TEST_CASE("without injection no bump is accepted") {
  BumpNetwork network({.injection = 0});
  const LearnedPattern start = network.currentPattern();
  for (int i = 0; i < 50; ++i) {
    drive(network, 5, 2 * std::numbers::pi / 50);
    CHECK_FALSE(
        network
            .inject(start, network.code().between(start.pattern, network.state().integrator.centre),
                    kMeasured)
            .accepted);
  }
}

TEST_CASE("with one grid module a view one period away is as good as the true one") {
  const auto accepted = [](int modules) {
    BumpNetwork network({.modules = modules});
    const LearnedPattern start = network.currentPattern();
    drive(network, 150);  // one period
    return network.inject(start, {}, kMeasured).accepted;
  };
  CHECK(accepted(1));
  CHECK_FALSE(accepted(4));
}

TEST_CASE("after startPart() views that agree accept a bump, and the two parts are joined") {
  BumpNetwork network({});
  std::vector<LearnedPattern> seen;
  for (int i = 0; i < 400; ++i) {
    seen.push_back(network.currentPattern());
    drive(network, 1, i % 100 < 50 ? 0.01 : -0.02);
  }
  network.startPart();
  drive(network, 30);
  LearnedPattern meanwhile = network.currentPattern();
  std::size_t views = 0;
  Recalibration calibrated;
  while (!calibrated.accepted && views < 20) {
    calibrated = network.inject(seen[100 + 5 * views++], {}, kMeasured);
    if (!calibrated.accepted) drive(network, 5, 0.01);
  }
  REQUIRE(calibrated.accepted);
  CHECK(views >= 3);
  CHECK(calibrated.joined_part == 1);
  CHECK(network.state().part == 0);
  const PlanarPose before = network.code().between(calibrated.from.centre, meanwhile.pattern);
  network.follow(calibrated, meanwhile);
  CHECK(meanwhile.part == 0);
  const PlanarPose after = network.code().between(calibrated.to.centre, meanwhile.pattern);
  CHECK(after.x == Approx(before.x));
  CHECK(after.theta == Approx(before.theta));
}

TEST_CASE("the share of right views is learned: after many look-alikes more support is needed") {
  const auto energyAfter = [](int lies) {
    BumpNetwork network({});
    const LearnedPattern start = network.currentPattern();
    drive(network, 300);
    RandomStream random(5);
    for (int i = 0; i < lies; ++i) {
      network.inject(start, {random.uniform(40, 200), random.uniform(20, 60), 1}, kMeasured);
    }
    network.inject(start, {290, 0, 0}, kMeasured);
    return strongest(network).energy;
  };
  CHECK(energyAfter(0) - energyAfter(400) > 1);
}
