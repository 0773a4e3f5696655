// SPDX-License-Identifier: BSD-3-Clause
// Pose estimation on points with known noise and known outliers.
#include "pnp.hpp"

#include <catch2/catch.hpp>

#include "support/street_scene.hpp"

using namespace tolman;
using namespace tolman::feature_stereo;

namespace {

const Eigen::Isometry3d kTruth =
    expSe3((Vector6d() << 0.3, -0.1, 1.2, 0.02, -0.05, 0.01).finished());

/// `count` exact points seen from kTruth with the settings' noise, every `nth` of them wrongly.
std::vector<PointMatch> matches(int count, int nth, const PnpSettings& settings,
                                RandomStream& random) {
  const CameraRig rig = test::streetRig();
  std::vector<PointMatch> seen;
  while (static_cast<int>(seen.size()) < count) {
    PointMatch s;
    s.point.coordinates << random.uniform(-0.7, 0.7), random.uniform(-0.3, 0.3),
        1 / random.uniform(4, 60);
    const auto pixel = project(rig, kTruth, s.point);
    if (!pixel) continue;
    const Eigen::Vector3d unit(random.normal(), random.normal(), random.normal());
    s.pixel = *pixel + settings.noise.sigma(pixel->z()).cwiseProduct(unit);
    s.has_disparity = seen.size() % 3 != 1;
    if (nth > 0 && static_cast<int>(seen.size()) % nth == 0) {
      s.pixel.x() = random.uniform(0, 480);
      s.pixel.y() = random.uniform(0, 200);
    }
    seen.push_back(s);
  }
  return seen;
}

}  // namespace

TEST_CASE("the pose is found among half wrong matches, from a wrong guess") {
  RandomStream scene(1);
  const PnpSettings settings;
  const auto seen = matches(300, 2, settings, scene);
  RandomStream random(5);
  const Eigen::Isometry3d guess =
      kTruth * expSe3((Vector6d() << 1, 0.2, -2, 0.05, 0.1, 0).finished());
  const auto estimate = estimatePose(test::streetRig(), seen, guess, settings, random);
  REQUIRE(estimate);
  const Vector6d error = logSe3(kTruth.inverse() * estimate->T_world_camera);
  CHECK(error.head<3>().norm() < 0.02);
  CHECK(error.tail<3>().norm() < 0.001);
  int wrong_but_kept = 0;
  for (std::size_t i = 0; i < seen.size(); i += 2) wrong_but_kept += estimate->inlier[i] ? 1 : 0;
  CHECK(wrong_but_kept <= 2);
  CHECK(estimate->inliers > 140);
}

TEST_CASE("the covariance fits the errors") {
  // Normalised squared errors of a 6-vector have the mean 6.
  RandomStream scene(2);
  const PnpSettings settings;
  double sum = 0;
  constexpr int kTries = 100;
  for (int k = 0; k < kTries; ++k) {
    const auto seen = matches(100, 0, settings, scene);
    RandomStream random(5);
    const auto estimate = estimatePose(test::streetRig(), seen, kTruth, settings, random);
    REQUIRE(estimate);
    const Vector6d error = logSe3(estimate->T_world_camera.inverse() * kTruth);
    sum += error.dot(estimate->covariance.ldlt().solve(error));
  }
  CHECK(sum / kTries > 4);
  CHECK(sum / kTries < 9);
}

TEST_CASE("uncertain points count less") {
  RandomStream scene(3);
  const PnpSettings settings;
  auto seen = matches(200, 0, settings, scene);
  RandomStream random(5);
  const auto sure = estimatePose(test::streetRig(), seen, kTruth, settings, random);
  for (PointMatch& s : seen) s.point_covariance(2, 2) = 0.01 * 0.01;
  const auto unsure = estimatePose(test::streetRig(), seen, kTruth, settings, random);
  REQUIRE(sure);
  REQUIRE(unsure);
  CHECK(unsure->covariance(2, 2) > 2 * sure->covariance(2, 2));
}

TEST_CASE("too few matches, or none that agree, give no pose") {
  RandomStream scene(4);
  const PnpSettings settings;
  RandomStream random(5);
  const auto few = matches(settings.min_inliers - 1, 0, settings, scene);
  CHECK_FALSE(estimatePose(test::streetRig(), few, kTruth, settings, random));
  const auto noise = matches(60, 1, settings, scene);
  CHECK_FALSE(estimatePose(test::streetRig(), noise, kTruth, settings, random));
}

TEST_CASE("the same stream gives the same bits") {
  RandomStream scene(6);
  const PnpSettings settings;
  const auto seen = matches(200, 3, settings, scene);
  const Eigen::Isometry3d guess = Eigen::Isometry3d::Identity();
  RandomStream a(9);
  RandomStream b(9);
  const auto first = estimatePose(test::streetRig(), seen, guess, settings, a);
  const auto second = estimatePose(test::streetRig(), seen, guess, settings, b);
  REQUIRE(first);
  CHECK(first->T_world_camera.matrix() == second->T_world_camera.matrix());
  CHECK(first->covariance == second->covariance);
}
