// SPDX-License-Identifier: BSD-3-Clause
// The paper's residual, its derivatives, and the wrap of angles.
#include <catch2/catch.hpp>
#include <tolman/context.hpp>

#include "pose_link.hpp"

namespace tolman::experience_map {
namespace {

PlanarPose randomNode(RandomStream& random) {
  return {random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-3.1, 3.1)};
}

PlanarPose nudged(PlanarPose pose, int axis, double amount) {
  (axis == 0 ? pose.x : axis == 1 ? pose.y : pose.theta) += amount;
  return pose;
}

Eigen::Matrix3d someCovariance(RandomStream& random) {
  Eigen::Matrix3d root;
  for (double& value : root.reshaped()) value = random.normal();
  return root * root.transpose() + 0.01 * Eigen::Matrix3d::Identity();
}

}  // namespace

TEST_CASE("the residual has the length of the paper's formula") {
  RandomStream random(1);
  for (int k = 0; k < 50; ++k) {
    const PlanarPose i = randomNode(random);
    const PlanarPose j = randomNode(random);
    const double d = random.uniform(0, 20);
    const double heading = random.uniform(-3, 3);
    const double facing = random.uniform(-3, 3);
    const Eigen::Vector3d paper(j.x - i.x - d * std::cos(i.theta + heading),
                                j.y - i.y - d * std::sin(i.theta + heading),
                                wrapAngle(j.theta - i.theta - facing));
    PlanarLink link;
    link.pose = {d * std::cos(heading), d * std::sin(heading), facing};
    const Eigen::Vector3d ours = residualOf(link, i, j);
    CHECK(ours.head<2>().norm() == Approx(paper.head<2>().norm()));
    CHECK(ours.z() == Approx(paper.z()).margin(1e-12));
    // and is the paper's vector turned into the axes of e_i
    const Eigen::Vector2d turned = Eigen::Rotation2Dd(i.theta) * ours.head<2>();
    CHECK((turned - paper.head<2>()).norm() < 1e-11);
  }
}

TEST_CASE("the derivatives agree with central differences") {
  RandomStream random(2);
  PlanarLink link;
  link.pose = {3, -1, 0.4};
  for (int k = 0; k < 20; ++k) {
    const PlanarPose i = randomNode(random);
    const PlanarPose j = randomNode(random);
    const LinkDerivatives<Plane> by = derivativesOf(link, i, j);
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double kStep = 1e-6;
      const Eigen::Vector3d by_i = (residualOf(link, nudged(i, axis, kStep), j) -
                                    residualOf(link, nudged(i, axis, -kStep), j)) /
                                   (2 * kStep);
      const Eigen::Vector3d by_j = (residualOf(link, i, nudged(j, axis, kStep)) -
                                    residualOf(link, i, nudged(j, axis, -kStep))) /
                                   (2 * kStep);
      CHECK((by_i - by.by_from.col(axis)).norm() < 1e-6 * (1 + by_i.norm()));
      CHECK((by_j - by.by_to.col(axis)).norm() < 1e-6 * (1 + by_j.norm()));
    }
  }
}

TEST_CASE("a turn across pi is a small turn") {
  PlanarLink link;
  link.pose = {1, 0, 0.2};
  const PlanarPose j = {std::cos(3.1), std::sin(3.1), wrapAngle(3.3)};
  CHECK(j.theta < 0);
  CHECK(residualOf(link, {0, 0, 3.1}, j).norm() < 1e-12);
}

TEST_CASE("information inverts the covariance, and survives a singular one") {
  RandomStream random(4);
  const Eigen::Matrix3d covariance = someCovariance(random);
  CHECK((informationOf(covariance) * covariance - Eigen::Matrix3d::Identity()).norm() < 1e-8);
  CHECK(informationOf(Eigen::Matrix3d(Eigen::Matrix3d::Zero())).allFinite());
}

}  // namespace tolman::experience_map
