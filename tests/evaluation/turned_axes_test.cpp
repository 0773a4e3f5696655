// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/turned_axes.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "evaluation/metrics.hpp"
#include "evaluation/paths.hpp"
#include "evaluation/turns.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

/// A car through bends and over bumps: yaw by the way, pitch and roll by the road.
Trajectory bumpyDrive(double noise_deg = 0, double noise_m = 0) {
  RandomStream random(8);
  Trajectory path = test::straightPath(600);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto t = static_cast<double>(i);
    Vector6d twist;
    twist << 0, 0, 1, 0.4 * kDegree * std::sin(0.8 * t), 1.5 * kDegree * std::sin(0.05 * t),
        0.2 * kDegree * std::sin(0.5 * t);
    for (int k = 0; k < 3; ++k) twist[k] += noise_m * random.normal();
    for (int k = 3; k < 6; ++k) twist[k] += noise_deg * kDegree * random.normal();
    T = normalised(T * expSe3(twist));
    path[i].T_world_camera = T;
  }
  return path;
}

/// The same path of a camera that is mounted otherwise.
Trajectory turned(Trajectory path, double degrees, const Eigen::Vector3d& axis) {
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(degrees * kDegree, axis));
  for (TrajectoryPose& pose : path) pose.T_world_camera = pose.T_world_camera * turn;
  return path;
}

/// Seen in a mirror: rotations as well.
Trajectory mirrored(Trajectory path, int axis) {
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
  mirror(axis, axis) = -1;
  for (TrajectoryPose& pose : path) {
    Eigen::Isometry3d& T = pose.T_world_camera;
    T.linear() = (mirror * T.linear() * mirror).eval();
    T.translation() = (mirror * T.translation()).eval();
  }
  return path;
}

std::string turnedHintOf(const Trajectory& truth, const Trajectory& estimate) {
  return turnedAxesHint(test::paired(truth, estimate));
}

}  // namespace

TEST_CASE("a camera that is turned by a constant angle is told, about each axis") {
  const Trajectory estimate = bumpyDrive(0.05, 0.01);
  const Eigen::Vector3d axis =
      GENERATE(Eigen::Vector3d(Eigen::Vector3d::UnitX()), Eigen::Vector3d(Eigen::Vector3d::UnitY()),
               Eigen::Vector3d(Eigen::Vector3d::UnitZ()));
  const double degrees = GENERATE(-90, -30, 20, 44, 90);
  CAPTURE(axis, degrees);
  const Trajectory truth = turned(bumpyDrive(), degrees, axis);
  CHECK_THAT(turnedHintOf(truth, estimate), Catch::StartsWith("the camera of the truth is turned"));
  for (const Alignment alignment : {Alignment::Se3, Alignment::Sim3, Alignment::None}) {
    CHECK_FALSE(scoreTrajectory(truth, estimate, alignment).warning.empty());
  }
}

TEST_CASE("a camera that looks 5 degrees down is told, 2 degrees are not") {
  const Trajectory estimate = bumpyDrive(0.05, 0.01);
  CHECK_FALSE(turnedHintOf(turned(bumpyDrive(), 5, Eigen::Vector3d::UnitX()), estimate).empty());
  CHECK(turnedHintOf(turned(bumpyDrive(), 2, Eigen::Vector3d::UnitX()), estimate).empty());
}

TEST_CASE("noisy and poor estimates give no hint of turned or mirrored axes") {
  for (const double noise : {0.0, 0.1, 1.0, 5.0}) {
    CAPTURE(noise);
    const Trajectory estimate = bumpyDrive(noise, 0.2 * noise);
    CHECK(turnedHintOf(bumpyDrive(), estimate).empty());
    CHECK(oppositeAxisHint(test::paired(bumpyDrive(), estimate)).empty());
  }
  RandomStream random(4);
  const Trajectory one = test::wanderingPath(300, random);
  const Trajectory other = test::wanderingPath(300, random);
  CHECK(turnedHintOf(one, other).empty());
  CHECK(oppositeAxisHint(test::paired(one, other)).empty());
  CHECK(turnedHintOf(test::straightPath(100), test::straightPath(100)).empty());
  CHECK(turnedHintOf(test::straightPath(100, 0), test::straightPath(100)).empty());
}

TEST_CASE("turns that are opposite about one axis are told with the axis") {
  const Trajectory estimate = bumpyDrive(0.05, 0.01);
  const auto hint = [&](int axis) {
    return oppositeAxisHint(test::paired(mirrored(bumpyDrive(), axis), estimate));
  };
  // The mirror image of y turns about x and z the other way.
  CHECK_THAT(hint(1), Catch::Contains("axis x (pitch)"));
  CHECK_THAT(hint(0), Catch::Contains("axis y (yaw)"));
  CHECK_THAT(hint(2), Catch::Contains("axis x (pitch)"));
  for (const Alignment alignment : {Alignment::Se3, Alignment::Sim3, Alignment::None}) {
    CHECK_FALSE(scoreTrajectory(mirrored(bumpyDrive(), 1), estimate, alignment).warning.empty());
  }
}
