// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/motion_consistency.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "tolman/context.hpp"
#include "tolman/geometry.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

constexpr std::int64_t kMotions = 4000;

/// Different in each direction, with position and heading correlated.
Matrix6d claimed() {
  Vector6d sigma;
  sigma << 0.02, 0.01, 0.05, 0.002, 0.004, 0.001;
  Matrix6d covariance = sigma.array().square().matrix().asDiagonal();
  covariance(0, 4) = covariance(4, 0) = 0.6 * sigma[0] * sigma[4];
  return covariance;
}

/// Motions along a curve whose errors are drawn from `claimed()`, times `exaggeration`.
struct Drive {
  Trajectory truth;
  std::vector<Motion> motions;

  explicit Drive(double exaggeration) {
    RandomStream random(5);
    const Matrix6d root = claimed().llt().matrixL();
    Vector6d twist;
    twist << 0, 0, 1, 0, 0.03, 0;
    const Eigen::Isometry3d step = expSe3(twist);
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    for (std::int64_t i = 0; i <= kMotions; ++i) {
      truth.push_back({i, i, T});
      T = T * step;
      Motion motion;
      motion.frame = i;
      motion.state = i == 0 ? TrackingState::Initialising : TrackingState::Tracking;
      motion.covariance = claimed();
      Vector6d draw;
      for (double& x : draw) x = random.normal();
      motion.T_previous_current = step * expSe3(Vector6d(exaggeration * (root * draw))).inverse();
      motions.push_back(motion);
    }
  }
  MotionConsistency measured(bool planar = false) const {
    MotionErrors errors(truth, planar);
    for (const Motion& motion : motions) errors.add(motion);
    return errors.result();
  }
};

}  // namespace

TEST_CASE("Errors that fit their covariance have the degrees of freedom as mean") {
  const Drive drive(1);
  const MotionConsistency all = drive.measured();
  CHECK(all.motions == kMotions);
  CHECK(all.degrees_of_freedom == 6);
  CHECK(all.mean == Approx(6).epsilon(0.05));
  CHECK(all.share_99 == Approx(0.99).margin(0.006));
  const MotionConsistency planar = drive.measured(true);
  CHECK(planar.degrees_of_freedom == 3);
  CHECK(planar.mean == Approx(3).epsilon(0.05));
  CHECK(planar.share_99 == Approx(0.99).margin(0.006));
}

TEST_CASE("Errors twice as large as their covariance give four times the mean") {
  const MotionConsistency twice = Drive(2).measured();
  CHECK(twice.mean == Approx(24).epsilon(0.05));
  CHECK(twice.share_99 < 0.7);
}

TEST_CASE("Motions that are lost, without scale, or without truth at an end are left out") {
  Drive drive(1);
  drive.motions[10].state = TrackingState::Lost;
  drive.motions[20].scale_known = false;
  drive.truth.erase(drive.truth.begin() + 30);  // both motions that end there
  CHECK(drive.measured().motions == kMotions - 4);
  drive.truth.clear();
  const auto json = toJson(drive.measured());
  CHECK(json["mean"].is_null());
  CHECK(json["share_within_99"].is_null());
  CHECK(json["reason"].is_string());
}

TEST_CASE("A covariance of zero is counted, not divided by") {
  Drive drive(1);
  for (Motion& motion : drive.motions) motion.covariance.setZero();
  const MotionConsistency none = drive.measured();
  CHECK(none.without_covariance == kMotions);
  CHECK(none.share_99 == 0);
  CHECK(toJson(none)["mean"].is_null());
}
