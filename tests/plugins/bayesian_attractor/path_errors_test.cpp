// SPDX-License-Identifier: BSD-3-Clause
// Effects of steady errors against path integration with those errors, and what loops say of them.
#include "path_errors.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bump_network.hpp"

namespace tolman::bayesian_attractor {
namespace {

constexpr double kSecond = 0.4;  // of a step

/// A side of 40 m in steps of 1 m, then a quarter turn.
PlanarPose stepOf(int k) { return {1, 0, k % 40 == 39 ? std::acos(-1.0) / 2 : 0.02}; }

Eigen::Matrix3d quiet() { return Eigen::Vector3d(1e-4, 1e-4, 1e-7).asDiagonal(); }

PlanarPose corrected(const PlanarPose& step, const ErrorVector& b) {
  const Eigen::Vector3d by = effectOf(step, kSecond) * b;
  return {step.x + by.x(), step.y + by.y(), step.theta + by.z()};
}

}  // namespace

TEST_CASE("effects of steady errors are the derivatives of path integration") {
  const ConjunctiveCode code(GridCode(150, 4, 0.005));
  Bump bump{code.origin()};
  for (int k = 0; k < 130; ++k) {
    code.move(bump, stepOf(k), quiet(), {}, {effectOf(stepOf(k), kSecond), {}});
  }
  constexpr double kSmall = 1e-6;
  for (int error = 0; error < kPathErrors; ++error) {
    Bump wrong{code.origin()};
    for (int k = 0; k < 130; ++k) {
      code.move(wrong, corrected(stepOf(k), kSmall * ErrorVector::Unit(error)), quiet());
    }
    const Eigen::Vector3d numeric = code.difference(bump.centre, wrong.centre) / kSmall;
    CAPTURE(error, numeric.transpose(), bump.errors.effect.col(error).transpose());
    CHECK((numeric - bump.errors.effect.col(error)).norm() < 1e-2 * numeric.norm() + 1e-3);
  }
}

TEST_CASE("loops teach a robot that it turns too little, and how well it knows that") {
  ErrorVector truth = ErrorVector::Zero();
  truth[2] = 0.003;  // rad/m
  BumpNetwork network(NetworkSettings{});
  const ErrorMatrix prior = network.state().path.estimates[0].covariance;
  std::vector<LearnedPattern> learned;
  int closed = 0;
  for (int k = 0; k < 5 * 160; ++k) {
    // The laps are closed in truth, so the odometry lacks what is missing in it.
    const PlanarPose step = {1, 0, k % 40 == 39 ? std::acos(-1.0) / 2 : 0};
    network.integrate({1, 0, step.theta - truth[2]}, quiet(), {}, kSecond);
    if (k < 160) {
      learned.push_back(network.currentPattern());
    } else if (k % 6 == 0) {
      const auto there = learned[static_cast<std::size_t>(k % 160)];
      if (network.inject(there, {}, Eigen::Vector3d(0.04, 0.04, 1e-4).asDiagonal()).accepted)
        ++closed;
    }
  }
  const RunningCalibration& path = network.state().path;
  const ErrorEstimate& wide = path.estimates[0];
  // A lap turns by 2 pi, in 64 s and 160 m; loops cannot tell which of them an error grows with.
  const Eigen::Vector3d lap(2 * std::acos(-1.0), 160 * kSecond, 160);
  const double missing = lap.dot(path.mixed.mean.head<3>());
  const double sigma = std::sqrt(lap.dot(wide.covariance.topLeftCorner<3, 3>() * lap));
  CAPTURE(closed, path.mixed.mean.transpose(), sigma);
  CHECK(closed > 20);
  CHECK(missing == Approx(160 * truth[2]).epsilon(0.1));
  CHECK(sigma < 0.1 * std::sqrt(lap.cwiseAbs2().dot(prior.diagonal().head<3>())));
  CHECK(std::exp(wide.log_weight) > 0.9);  // it is not well calibrated
}

TEST_CASE("a loop of which odometry makes a spiral teaches the steady turn, in one step") {
  // A rectangle of 210 x 90 m, reported 0.008 rad/m short: 4.8 rad in a lap.
  const double missing = GENERATE(0.008, -0.008, 0.0);
  PathHistory path;
  const auto drive = [&](int metres, double corner) {
    for (int k = 0; k < metres; ++k) {
      const PlanarPose step = {1, 0, (k == metres - 1 ? corner : 0) - missing};
      path.advance(step, step, quiet(), effectOf(step, kSecond), 5);
    }
  };
  drive(30, 0);
  path.advance({}, {}, Eigen::Matrix3d::Zero(), ErrorEffect::Zero(), 0);  // a piece begins
  const std::int64_t there = path.last();
  const PlanarPose offset = between(path.beginOf(there), path.here());
  for (const int side : {210, 90, 210, 90}) drive(side, std::acos(-1.0) / 2);
  const TracedView view = {there, offset, Eigen::Vector3d(0.04, 0.04, 1e-4).asDiagonal()};
  ErrorEstimate prior = RunningCalibration::priors()[0];
  // Else a gain of turns explains a part of it: a lap turns by 2 pi.
  prior.covariance(0, 0) = prior.covariance(1, 1) = 1e-12;
  const TracedLoop loop = traceLoop(path, prior, view, 4);
  CHECK(loop.estimate.mean[2] == Approx(missing).margin(2e-4));
  // The place could not be another: a view 60 m beside it is less likely.
  TracedView wrong = view;
  wrong.pose.y += 60;
  CHECK(traceLoop(path, prior, wrong, 4).density < 1e-3 * loop.density);
}

TEST_CASE("a part of the path that joins another one begins where the way back leads") {
  PathHistory path;
  const auto drive = [&](int metres, double turn) {
    for (int k = 0; k < metres; ++k) {
      path.advance({1, 0, turn}, {1, 0, turn}, quiet(), effectOf({1, 0, turn}, kSecond), 5);
    }
    path.advance({}, {}, Eigen::Matrix3d::Zero(), ErrorEffect::Zero(), 0);  // a piece begins
    return path.last();
  };
  drive(20, 0.02);
  const std::int64_t there = drive(7, -0.1);
  path.startPart();
  const std::int64_t end = drive(30, 0.05);
  const PlanarPose offset = {2, 1, 0.3};
  path.join(there, offset, quiet());
  const PlanarPose met = between(path.beginOf(there), path.beginOf(end));
  CHECK(std::hypot(met.x - offset.x, met.y - offset.y) + std::abs(met.theta - offset.theta) < 1e-9);
  // Traced again with other errors it still ends there, up to second order.
  ErrorVector errors;
  errors << 0.01, 2e-4, 2e-4, 0.01;
  const std::vector<Traced> traced = path.trace(errors);
  const PlanarPose again = between(traced[static_cast<std::size_t>(there)].pose,
                                   traced[static_cast<std::size_t>(end)].pose);
  CHECK(std::hypot(again.x - offset.x, again.y - offset.y) < 0.02);
  CHECK(again.theta == Approx(offset.theta).margin(1e-6));
  path.jump(there, offset, quiet());
  CHECK(path.here().x == Approx(path.beginOf(end).x));
  CHECK(path.firstOfWay(end) <= there);
}

TEST_CASE("the gain of distances stays as uncertain as it was, and widens the position") {
  ErrorEstimate estimate = RunningCalibration::priors()[0];
  const double before = estimate.covariance(3, 3);
  ErrorEffect effect = ErrorEffect::Zero();
  effect(0, 3) = 100;
  effect(2, 1) = 50;
  update(estimate, effect, {2, 0, 0.1}, Eigen::Vector3d(1, 1, 1e-4).asDiagonal());
  CHECK(estimate.mean[3] == 0);
  CHECK(estimate.covariance(3, 3) == Approx(before));
  CHECK(estimate.mean[1] == Approx(0.002).epsilon(0.01));
}

}  // namespace tolman::bayesian_attractor
