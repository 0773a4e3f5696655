// SPDX-License-Identifier: BSD-3-Clause
// True paths that are the mirror image of the estimate's.
#include "evaluation/mirror_hint.hpp"

#include <catch2/catch.hpp>

#include "evaluation/errors.hpp"
#include "evaluation/metrics.hpp"
#include "evaluation/paths.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

/// Streets over hills: positions of poses whose rotations follow the way in the plane.
Trajectory hilly(double height, int poses = 300) {
  Trajectory path;
  for (int i = 0; i < poses; ++i) {
    const double angle = 0.02 * i;
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
    T.translation() << 100 * (1 - std::cos(angle)), height * std::sin(0.07 * i),
        100 * std::sin(angle);
    path.push_back({i, 100'000'000LL * i, T, true});
  }
  return path;
}

/// With errors of about `metres`.
Trajectory noisy(Trajectory path, double metres) {
  RandomStream random(3);
  for (TrajectoryPose& pose : path) {
    for (int axis = 0; axis < 3; ++axis) {
      pose.T_world_camera.translation()[axis] += metres * random.normal();
    }
  }
  return path;
}

}  // namespace

TEST_CASE("a mirrored height is told with every alignment, with the errors of both fits") {
  const Trajectory estimate = noisy(hilly(8), 0.1);
  for (const Alignment alignment : {Alignment::Se3, Alignment::Sim3, Alignment::None}) {
    const std::string warning = scoreTrajectory(hilly(-8), estimate, alignment).warning;
    CHECK_THAT(warning, Catch::StartsWith("the true path agrees with the mirror image"));
    CHECK(scoreTrajectory(hilly(8), estimate, alignment).warning.empty());
  }
  CHECK_THAT(mirrorHint(test::paired(hilly(-8), estimate)), Catch::Contains("to 0.17"));
}

TEST_CASE("paths in a plane and straight ones have no mirror image of their own") {
  CHECK(mirrorHint(test::paired(hilly(0), noisy(hilly(0), 0.5))).empty());
  CHECK(
      mirrorHint(test::paired(test::straightPath(100), noisy(test::straightPath(100), 1))).empty());
  CHECK(mirrorHint(test::paired(hilly(0), hilly(0))).empty());
}

TEST_CASE("poor heights are no mirror image") {
  CHECK(mirrorHint(test::paired(hilly(8), hilly(0))).empty());         // none are estimated
  CHECK(mirrorHint(test::paired(hilly(-8), hilly(4))).empty());        // the errors remain
  CHECK(mirrorHint(test::paired(hilly(-8, 9), hilly(8, 9))).empty());  // too few poses
  RandomStream random(4);
  const Trajectory one = test::wanderingPath(200, random);
  CHECK(mirrorHint(test::paired(one, test::wanderingPath(200, random))).empty());
}
