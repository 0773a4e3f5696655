// SPDX-License-Identifier: BSD-3-Clause
// Bumps: moving, widening, fusing, against samples and closed forms.
#include "conjunctive_code.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;

namespace {

const ConjunctiveCode kCode(GridCode(150, 4, 0.005));

Bump atOrigin() { return {kCode.origin()}; }

}  // namespace

TEST_CASE("a pattern is displaced in its own axes, and between() undoes it") {
  const FiringPattern start = kCode.displaced(kCode.origin(), {100, 20, 2});
  const FiringPattern end = kCode.displaced(start, {30, -5, -2.5});
  const PlanarPose way = kCode.between(start, end);
  CHECK(way.x == Approx(30));
  CHECK(way.y == Approx(-5));
  CHECK(way.theta == Approx(-2.5));
}

TEST_CASE("path integration widens a bump as sampled noise does") {
  constexpr double kTurnSigma = 0.01;
  constexpr double kStepSigma = 0.05;
  const PlanarPose step{1, 0, 0.01};
  const Eigen::Vector3d noise(kStepSigma * kStepSigma, kStepSigma * kStepSigma,
                              kTurnSigma * kTurnSigma);
  Bump bump = atOrigin();
  for (int i = 0; i < 100; ++i) kCode.move(bump, step, noise.asDiagonal());

  RandomStream random(1);
  const PlanarPose mean = kCode.between(kCode.origin(), bump.centre);
  Eigen::Matrix3d sampled = Eigen::Matrix3d::Zero();
  constexpr int kSamples = 20000;
  for (int sample = 0; sample < kSamples; ++sample) {
    PlanarPose pose;
    for (int i = 0; i < 100; ++i) {
      pose = compose(pose, {step.x + kStepSigma * random.normal(), kStepSigma * random.normal(),
                            step.theta + kTurnSigma * random.normal()});
    }
    const Eigen::Vector3d off(pose.x - mean.x, pose.y - mean.y, wrapAngle(pose.theta - mean.theta));
    sampled += off * off.transpose() / kSamples;
  }
  for (int i = 0; i < 3; ++i) CHECK(bump.covariance(i, i) == Approx(sampled(i, i)).epsilon(0.06));
  CHECK(bump.covariance(1, 2) == Approx(sampled(1, 2)).epsilon(0.06));
}

TEST_CASE("fusing adds precisions, as the paper's injection does") {
  Bump bump = atOrigin();
  bump.covariance = Eigen::Vector3d(4, 4, 0.04).asDiagonal();
  const FiringPattern seen = kCode.displaced(kCode.origin(), {3, 0, 0.1});
  kCode.fuse(bump, seen, Eigen::Vector3d(2, 2, 0.01).asDiagonal());
  const PlanarPose mean = kCode.between(kCode.origin(), bump.centre);
  CHECK(mean.x == Approx(3 * 4 / 6.0));
  CHECK(mean.theta == Approx(0.1 * 0.04 / 0.05));
  CHECK(bump.covariance(0, 0) == Approx(1 / (1 / 4.0 + 1 / 2.0)));
  CHECK(bump.covariance(2, 2) == Approx(1 / (1 / 0.04 + 1 / 0.01)));
}

TEST_CASE("headings fuse across the seam") {
  Bump bump = {kCode.displaced(kCode.origin(), {0, 0, -0.1})};
  bump.covariance = Eigen::Vector3d(1, 1, 0.01).asDiagonal();
  kCode.fuse(bump, kCode.displaced(kCode.origin(), {0, 0, 0.1}),
             Eigen::Vector3d(1, 1, 0.01).asDiagonal());
  CHECK(std::abs(wrapAngle(bump.centre.heading)) < 1e-12);
}

TEST_CASE("the distance in heading is that of von Mises: opposite directions are finitely far") {
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity();
  CHECK(squaredMahalanobis({0, 0, 0.1}, unit) == Approx(0.01).epsilon(1e-3));
  CHECK(squaredMahalanobis({0, 0, M_PI}, unit) == Approx(4));
}
