// SPDX-License-Identifier: BSD-3-Clause
// Covariance of dead reckoning against many noisy drives, and loops as short cuts.
#include "path_memory.hpp"

#include <catch2/catch.hpp>
#include <tolman/context.hpp>

using namespace tolman;
using namespace tolman::bayesian_attractor;

namespace {

constexpr double kStepSigma = 0.05;
constexpr double kTurnSigma = 0.004;
constexpr DriftSettings kDrift = {.heading = 5e-4, .scale = 0.02};

/// A drive with bends both ways, 2 m a step.
PlanarPose trueStep(int k) { return {2, 0, 0.08 * std::sin(0.05 * k) + 0.02}; }

/// The same as an odometry would see it: its own pull and scale, and noise in each step.
PathMemory noisyDrive(RandomStream& random, int steps, int mark_at, PathMark& mark) {
  PathMemory memory(kDrift);
  const double pull = kDrift.heading * random.normal();
  const double scale = 1 + kDrift.scale * random.normal();
  for (int k = 0; k < steps; ++k) {
    if (k == mark_at) mark = memory.now();
    PlanarPose step = trueStep(k);
    step.x = step.x * scale + kStepSigma * random.normal();
    step.y += kStepSigma * random.normal();
    step.theta += pull * 2 + kTurnSigma * random.normal();
    memory.advance(step, kStepSigma * kStepSigma, kTurnSigma * kTurnSigma);
  }
  return memory;
}

PathMemory straight(int steps, double turn_sigma = 1e-3) {
  PathMemory memory(DriftSettings{0, 0});
  for (int k = 0; k < steps; ++k) memory.advance({1, 0, 0}, 1e-4, turn_sigma * turn_sigma);
  return memory;
}

}  // namespace

TEST_CASE("the covariance between two moments is that of a thousand noisy drives") {
  constexpr int kDrives = 3000;
  RandomStream random(7);
  for (const bool backward : {false, true}) {
    PlanarPose truth;
    for (int k = 40; k < 120; ++k) truth = compose(truth, trueStep(k));
    if (backward) truth = between(truth, {});
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d claimed = Eigen::Matrix3d::Zero();
    for (int drive = 0; drive < kDrives; ++drive) {
      PathMark mark;
      const PathMemory memory = noisyDrive(random, 120, 40, mark);
      const UncertainStep step =
          backward ? memory.between(memory.now(), mark) : memory.between(mark, memory.now());
      const Eigen::Vector3d error(step.pose.x - truth.x, step.pose.y - truth.y,
                                  wrapAngle(step.pose.theta - truth.theta));
      scatter += error * error.transpose() / kDrives;
      claimed += step.covariance / kDrives;
    }
    INFO("scatter\n" << scatter << "\nclaimed\n" << claimed);
    for (int i = 0; i < 3; ++i) {
      CHECK(claimed(i, i) == Approx(scatter(i, i)).epsilon(0.15));
      for (int j = 0; j < i; ++j) {
        const double scale = std::sqrt(scatter(i, i) * scatter(j, j));
        CHECK(claimed(i, j) / scale == Approx(scatter(i, j) / scale).margin(0.1));
      }
    }
  }
}

TEST_CASE("a straight drive by hand: turns err sideways with the distance that follows") {
  // Turn k of n is followed by n - k metres: the sideways variance is the sum of their squares.
  const PathMemory memory = straight(10, 0.1);
  const UncertainStep step = memory.between(PathMark{}, memory.now());
  CHECK(step.pose.x == Approx(10));
  CHECK(step.covariance(2, 2) == Approx(10 * 0.01));
  CHECK(step.covariance(1, 1) == Approx(0.01 * 285 + 10 * 1e-4));  // 9^2 + ... + 1
  CHECK(step.covariance(1, 2) == Approx(0.01 * 45));
  CHECK(step.covariance(0, 0) == Approx(10 * 1e-4));
}

TEST_CASE("chaining adds, and the way back undoes the way") {
  const UncertainStep a = {{3, 1, 0.5}, Eigen::Vector3d(0.1, 0.2, 0.01).asDiagonal()};
  const UncertainStep twice = inverse(inverse(a));
  CHECK(twice.pose.x == Approx(a.pose.x));
  CHECK((twice.covariance - a.covariance).norm() < 1e-12);
  const UncertainStep b = {{2, 0, 0}, Eigen::Matrix3d::Zero()};
  // A heading error of 0.1 rad moves the end of 2 m by 0.2 m across a's heading.
  const Eigen::Vector2d across(-std::sin(0.5), std::cos(0.5));
  const Eigen::Matrix2d grown =
      chained(a, b).covariance.topLeftCorner<2, 2>() - a.covariance.topLeftCorner<2, 2>();
  CHECK((grown - 0.01 * 4 * across * across.transpose()).norm() < 1e-12);
}

TEST_CASE("a closed loop is a short cut from then on, and a contradicting one replaces it") {
  PathMemory memory = straight(400, 0.01);
  const PathMark start = {};
  const double unsure = memory.predict(start).covariance.determinant();
  const UncertainStep home = {{0, 0, 0}, 0.01 * Eigen::Matrix3d::Identity()};
  memory.close(start, home, 16);
  CHECK(memory.predict(start).pose.x == Approx(0).margin(1e-9));
  CHECK(memory.predict(start).covariance.determinant() < 1e-3 * unsure);
  memory.advance({1, 0, 0}, 1e-4, 1e-4);
  CHECK(memory.predict(start).pose.x == Approx(1));

  const UncertainStep elsewhere = {{50, 0, 0}, 0.01 * Eigen::Matrix3d::Identity()};
  memory.close(start, elsewhere, 16);
  CHECK(memory.state().loops.size() == 1);
  CHECK(memory.predict(start).pose.x == Approx(50));
}

TEST_CASE("the explored area is the path's rectangle with its margin") {
  PathMemory memory = straight(30);
  memory.advance({0, 10, 0}, 0, 0);
  CHECK(memory.exploredArea(0) == Approx(300));
  CHECK(memory.exploredArea(5) == Approx(40 * 20));
}
