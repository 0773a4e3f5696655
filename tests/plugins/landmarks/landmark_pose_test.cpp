// SPDX-License-Identifier: BSD-3-Clause
// Poses from matched landmarks whose true pose is known.
#include "landmark_pose.hpp"

#include <catch2/catch.hpp>

#include "support/street_scene.hpp"
#include "tolman/context.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;
using namespace tolman::landmarks;

namespace {

const Pinhole kPinhole = {400, 400, 319.5, 119.5};

/// Landmarks 4 to 40 m ahead, seen from `T_template_current` with `noise` px; the last `wrong` of
/// them somewhere else.
std::vector<LandmarkMatch> matches(RandomStream& random,
                                   const Eigen::Isometry3d& T_template_current, int count,
                                   double noise, int wrong) {
  std::vector<LandmarkMatch> result;
  while (static_cast<int>(result.size()) < count) {
    const double z = random.uniform(4, 40);
    const Eigen::Vector3d p(random.uniform(-0.7, 0.7) * z, random.uniform(-0.2, 0.2) * z, z);
    const Eigen::Vector3d q = T_template_current.inverse() * p;
    if (q.z() < 1) continue;
    Eigen::Vector2d pixel = kPinhole.project(q);
    pixel += noise * Eigen::Vector2d(random.normal(), random.normal());
    if (static_cast<int>(result.size()) >= count - wrong) {
      pixel = {random.uniform(0, 640), random.uniform(0, 240)};
    }
    const Eigen::Vector3f point = p.cast<float>();
    result.push_back({{point.x(), point.y(), point.z()},
                      {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())}});
  }
  return result;
}

Eigen::Isometry3d somewhere(RandomStream& random) {
  Vector6d twist;
  twist << random.uniform(-1, 1), random.uniform(-0.2, 0.2), random.uniform(-3, 3),
      random.uniform(-0.03, 0.03), random.uniform(-0.2, 0.2), random.uniform(-0.03, 0.03);
  return expSe3(twist);
}

}  // namespace

TEST_CASE("the pose is that of the majority, and its covariance tells the errors") {
  RandomStream random(8);
  double normalised_errors = 0;
  constexpr int kTrials = 60;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::Isometry3d truth = somewhere(random);
    const auto measured = poseOf(matches(random, truth, 120, 0.7, 40), kPinhole, 20, 1);
    REQUIRE(measured);
    const Vector6d error = logSe3(measured->T_template_current.inverse() * truth);
    CHECK(error.head<3>().norm() < 0.15);
    CHECK(error.tail<3>().norm() < 0.01);
    CHECK(measured->inliers >= 78);
    CHECK(measured->inliers <= 90);
    normalised_errors += error.dot(measured->covariance.ldlt().solve(error));
  }
  // Six degrees of freedom, noise 0.7 of the claimed pixel: 6 * 0.49 on average.
  CHECK(normalised_errors / kTrials == Approx(2.9).epsilon(0.35));
}

TEST_CASE("without noise the pose is exact; too few or contradicting matches give none") {
  RandomStream random(9);
  const Eigen::Isometry3d truth = somewhere(random);
  const auto exact = poseOf(matches(random, truth, 50, 0, 0), kPinhole, 20, 1);
  REQUIRE(exact);
  CHECK(exact->T_template_current.isApprox(truth, 1e-4));
  CHECK_FALSE(poseOf(matches(random, truth, 19, 0, 0), kPinhole, 20, 1));
  CHECK_FALSE(poseOf(matches(random, truth, 100, 0, 95), kPinhole, 20, 1));
  CHECK_FALSE(poseOf({}, kPinhole, 20, 1));
}

TEST_CASE("landmarks are found again in the picture from another place, where they are seen") {
  const CameraRig rig = tolman::test::streetRig();
  const Frame here = tolman::test::streetFrame(0, Eigen::Isometry3d::Identity());
  const Eigen::Isometry3d ahead(Eigen::Translation3d(0.1, 0, 0.8));
  const Frame there = tolman::test::streetFrame(1, ahead);
  const Landmarks stored =
      findLandmarks(asMat(here.left), asMat(here.right), rig, findCorners(asMat(here.left), 400));
  const Corners seen = findCorners(asMat(there.left), 400);
  const std::vector<LandmarkMatch> found = findAgain(stored, seen);
  REQUIRE(found.size() > 30);
  int right = 0;
  for (const LandmarkMatch& match : found) {
    const Eigen::Vector3d p(match.point.x, match.point.y, match.point.z);
    const Eigen::Vector2d expected = rig.pinhole.project(ahead.inverse() * p);
    right += (expected - Eigen::Vector2d(match.pixel.x, match.pixel.y)).norm() < 4 ? 1 : 0;
  }
  CHECK(right > static_cast<int>(0.7 * static_cast<double>(found.size())));
  CHECK(findAgain({}, seen).empty());
  CHECK(findAgain(stored, {}).empty());
}
