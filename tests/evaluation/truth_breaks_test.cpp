// SPDX-License-Identifier: BSD-3-Clause
// True poses of which a part does not belong to the drive of the estimate.
#include "evaluation/truth_breaks.hpp"

#include <catch2/catch.hpp>

#include "evaluation/metrics.hpp"
#include "evaluation/paths.hpp"
#include "evaluation/turns.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

constexpr std::size_t kHalf = 200;

/// A car that drives in wide bends and stops for a while; 1 m a frame.
Trajectory driveWithStop(double noise_m = 0, std::uint64_t seed = 3) {
  Trajectory path;
  RandomStream random(seed);
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 2 * kHalf; ++i) {
    const double angle = 2 * std::sin(0.02 * static_cast<double>(i));
    const bool stops = i >= 100 && i < 130;
    if (!stops) at += Eigen::Vector3d(std::sin(angle), 0, std::cos(angle));
    TrajectoryPose pose{static_cast<std::int64_t>(i), static_cast<std::int64_t>(i) * 100'000'000};
    pose.T_world_camera.linear() =
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
    pose.T_world_camera.translation() =
        at + noise_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    path.push_back(pose);
  }
  return path;
}

/// Held from pose `first` to `last`, with noise.
Trajectory heldWithNoise(Trajectory path, std::size_t first, std::size_t last, double noise_m) {
  RandomStream random(5);
  for (std::size_t i = first; i <= last; ++i) {
    path[i].T_world_camera = path[first].T_world_camera;
    path[i].T_world_camera.translation() +=
        noise_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  }
  return path;
}

/// The half from pose kHalf on, changed about that pose.
Trajectory withHalf(Trajectory path, double turn_rad, double scale) {
  const Eigen::Isometry3d T = path[kHalf].T_world_camera;
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
  for (std::size_t i = kHalf; i < path.size(); ++i) {
    Eigen::Isometry3d motion = T.inverse() * path[i].T_world_camera;
    motion.translation() *= scale;
    path[i].T_world_camera = T * turn * motion;
  }
  return path;
}

Trajectory withConstant(Trajectory path, int axis, std::size_t from) {
  const double value = path[from].T_world_camera.translation()[axis];
  for (std::size_t i = from; i < path.size(); ++i) {
    path[i].T_world_camera.translation()[axis] = value;
  }
  return path;
}

Trajectory withGap(Trajectory path, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i <= last; ++i) path[i].tracked = false;
  return path;
}

std::string warning(const Trajectory& truth, const Trajectory& estimate,
                    Alignment alignment = Alignment::Se3) {
  return scoreTrajectory(truth, estimate, alignment).warning;
}

}  // namespace

TEST_CASE("a truth or an estimate that stands but for noise while the other drives") {
  const Trajectory truth = driveWithStop();
  const Trajectory estimate = driveWithStop(0.02);
  for (const double noise_m : {1e-6, 1e-3, 0.05}) {
    CAPTURE(noise_m);
    CHECK_THAT(warning(heldWithNoise(truth, 300, 399, noise_m), estimate),
               Catch::StartsWith("the truth stands almost still from frame"));
    CHECK_THAT(warning(heldWithNoise(truth, 250, 265, noise_m), estimate),
               Catch::StartsWith("the truth stands almost still from frame"));
    CHECK_THAT(warning(truth, heldWithNoise(estimate, 250, 399, noise_m)),
               Catch::StartsWith("the estimate stands almost still from frame"));
  }
  const auto at_stop = test::paired(truth, driveWithStop(0.2));  // noise, but no way
  CHECK(standingHint(at_stop).empty());
  const auto lost = test::paired(heldWithNoise(truth, 300, 399, 1e-3), withGap(estimate, 290, 399));
  CHECK(standingHint(lost).empty());
}

TEST_CASE("a truth that turns in one step as nothing around it does") {
  const Trajectory truth = driveWithStop();
  const Trajectory estimate = driveWithStop(0.02);
  for (const double degrees : {-170.0, -10.0, 10.0, 45.0}) {
    CAPTURE(degrees);
    CHECK_THAT(turnJumpHint(test::paired(withHalf(truth, degrees * kDegree, 1), estimate)),
               Catch::Contains(", to frame 200, where the estimate turns by"));
  }
  CHECK_THAT(warning(withHalf(truth, 30 * kDegree, 1), estimate),
             Catch::StartsWith("the truth turns by 28.5 degrees in one step"));
  // Both turn so: a robot that is carried, or a low rate of images.
  CHECK(turnJumpHint(test::paired(withHalf(truth, 0.5, 1), withHalf(estimate, 0.5, 1))).empty());
  CHECK(turnJumpHint(test::paired(truth, withHalf(estimate, 0.5, 1))).empty());
  const Trajectory gap = withGap(estimate, kHalf - 1, kHalf + 1);
  CHECK(turnJumpHint(test::paired(withHalf(truth, 0.5, 1), gap)).empty());
}

TEST_CASE("lengths that change midway are told, a scale that drifts is not") {
  const Trajectory truth = driveWithStop();
  const Trajectory estimate = driveWithStop(0.02);
  for (const double scale : {0.001, 0.3048, 0.6, 3.28}) {
    CAPTURE(scale);
    CHECK_THAT(lengthChangeHint(test::paired(withHalf(truth, 0, scale), estimate)),
               Catch::Contains("does the truth change its unit"));
    if (scale < 0.1) continue;  // the scale of a whole alignment makes it stand almost still
    CHECK_THAT(warning(withHalf(truth, 0, scale), estimate, Alignment::Sim3),
               Catch::Contains("does the truth change its unit"));
  }
  CHECK(lengthChangeHint(test::paired(withHalf(truth, 0, 1.2), estimate)).empty());
  Trajectory drifting = truth;  // from 1 to 3 times as long
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const double scale = 1 + 2 * static_cast<double>(i) / static_cast<double>(truth.size());
    Eigen::Isometry3d step = truth[i - 1].T_world_camera.inverse() * truth[i].T_world_camera;
    step.translation() *= scale;
    drifting[i].T_world_camera = drifting[i - 1].T_world_camera * step;
  }
  CHECK(lengthChangeHint(test::paired(truth, drifting)).empty());
}

TEST_CASE("a coordinate that stays the same while the estimate moves along it") {
  const Trajectory truth = driveWithStop();
  const Trajectory estimate = driveWithStop(0.02);
  CHECK_THAT(warning(withConstant(truth, 0, 0), estimate),
             Catch::StartsWith("the truth has exactly one value of x from frame 0 to 399"));
  CHECK_THAT(constantCoordinateHint(test::paired(withConstant(truth, 2, kHalf), estimate)),
             Catch::StartsWith("the truth has exactly one value of z from frame 200 to 399"));
  CHECK(constantCoordinateHint(test::paired(truth, estimate)).empty());  // y is 0: a plane
}

TEST_CASE("nothing is told of right truths, whatever the noise of the estimate") {
  for (const double noise_m : {0.0, 0.01, 0.1, 0.3}) {
    CAPTURE(noise_m);
    const auto pairs = test::paired(driveWithStop(), driveWithStop(noise_m, 17));
    CHECK(standingHint(pairs).empty());
    CHECK(turnJumpHint(pairs).empty());
    CHECK(constantCoordinateHint(pairs).empty());
    CHECK(lengthChangeHint(pairs).empty());
  }
  RandomStream random(4);
  const Trajectory path = test::wanderingPath(300, random);
  const auto pairs = test::paired(path, path);
  CHECK(turnJumpHint(pairs).empty());
  CHECK(lengthChangeHint(pairs).empty());
  for (const std::int64_t poses : {1, 2, 5, 9}) {
    const auto few = test::paired(test::straightPath(poses), test::straightPath(poses));
    CHECK(standingHint(few).empty());
    CHECK(turnJumpHint(few).empty());
    CHECK(constantCoordinateHint(few).empty());
    CHECK(lengthChangeHint(few).empty());
  }
}
