// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/rounded_truth.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "evaluation/metrics.hpp"
#include "evaluation/paths.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

/// A drive through bends, in a world whose origin is far away.
Trajectory farDrive() {
  Trajectory path = test::straightPath(400);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double t = 0.01 * static_cast<double>(i);
    Eigen::Isometry3d& T = path[i].T_world_camera;
    T.linear() = Eigen::AngleAxisd(t, Eigen::Vector3d::UnitY()).toRotationMatrix();
    T.translation() << 4.5e6 + 60 * (1 - std::cos(t)), 100, 6e5 + 60 * std::sin(t);
  }
  return path;
}

Trajectory rounded(Trajectory path, double unit) {
  for (TrajectoryPose& pose : path) {
    for (double& value : pose.T_world_camera.translation()) value = unit * std::round(value / unit);
  }
  return path;
}

/// With an error that grows with the way, m at the end.
Trajectory drifting(Trajectory path, double metres) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    path[i].T_world_camera.translation().x() +=
        metres * static_cast<double>(i) / static_cast<double>(path.size());
  }
  return path;
}

}  // namespace

TEST_CASE("the unit of rounded positions, and the error that rounding makes") {
  for (const double unit : {10.0, 5.0, 1.11, 1.0, 0.5, 0.3048, 0.1, 0.0625, 0.002}) {
    CAPTURE(unit);
    const Rounding rounding = roundingOf(rounded(farDrive(), unit));
    CHECK(rounding.unit == Approx(unit));
    CHECK(rounding.error == Approx(unit * std::sqrt(2.0 / 12)));  // its height does not change
  }
  CHECK(roundingOf(farDrive()).error == 0);
  CHECK(roundingOf(test::straightPath(100)).error == 0);  // exact: all steps are of 1 m
  CHECK(roundingOf(test::straightPath(100, 0)).error == 0);
  Trajectory faster = test::straightPath(40);  // by 0.025 m each frame, up to 1 m
  double at = 0;
  for (std::size_t i = 0; i < faster.size(); ++i) {
    faster[i].T_world_camera.translation().z() = at;
    at += std::min(1.0, 0.4 + 0.025 * static_cast<double>(i));
  }
  CHECK(roundingOf(faster).error == 0);
  CHECK(roundingOf({}).error == 0);
}

TEST_CASE("rounded positions are told where they matter") {
  const Trajectory estimate = drifting(farDrive(), 0.5);
  for (const Alignment alignment : {Alignment::Se3, Alignment::Sim3, Alignment::None}) {
    CHECK(scoreTrajectory(farDrive(), estimate, alignment).warning.empty());
    CHECK(scoreTrajectory(rounded(farDrive(), 0.01), estimate, alignment).warning.empty());
    CHECK_THAT(scoreTrajectory(rounded(farDrive(), 1), estimate, alignment).warning,
               Catch::StartsWith("the true positions are multiples of 1 m, which alone makes an "
                                 "error of 0.41 m"));
  }
}

TEST_CASE("an error without that of the rounding, or far above it, is none of rounding") {
  const Rounding rounding{1, 0.4};
  CHECK(roundedHint(rounding, 0.1).empty());
  CHECK_FALSE(roundedHint(rounding, 0.3).empty());
  CHECK_FALSE(roundedHint(rounding, 1.1).empty());
  CHECK(roundedHint(rounding, 1.3).empty());
  CHECK(roundedHint({}, 0).empty());
}
