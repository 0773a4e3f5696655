// SPDX-License-Identifier: BSD-3-Clause
// Residuals in space: zero for a link that fits, derivatives against finite differences, and
// independence of the world frame.
#include <catch2/catch.hpp>
#include <tolman/context.hpp>

#include "pose_link.hpp"

namespace tolman::experience_map {
namespace {

Eigen::Isometry3d randomNode(RandomStream& random, double metres, double radians) {
  Vector6d twist;
  for (int k = 0; k < 6; ++k) twist[k] = (k < 3 ? metres : radians) * random.uniform(-1, 1);
  return expSe3(twist);
}

}  // namespace

TEST_CASE("a link that fits has no residual, another has the twist to where the end is") {
  RandomStream random(1);
  for (int k = 0; k < 50; ++k) {
    SpatialLink link;
    link.pose = randomNode(random, 10, 1.5);
    const Eigen::Isometry3d from = randomNode(random, 50, 1.5);
    CHECK(residualOf(link, from, from * link.pose).norm() < 1e-12);
    const Vector6d off = (Vector6d() << 0.3, -0.1, 0.2, 0.05, -0.02, 0.6).finished();
    const Eigen::Isometry3d to = from * link.pose * expSe3(off);
    CHECK((residualOf(link, from, to) - off).norm() < 1e-11);
  }
}

TEST_CASE("spatial derivatives agree with central differences, for residuals up to 1.7 rad") {
  RandomStream random(2);
  for (int k = 0; k < 40; ++k) {
    SpatialLink link;
    link.pose = randomNode(random, 5, 1);
    const Eigen::Isometry3d i = randomNode(random, 30, 1.5);
    const Eigen::Isometry3d j = i * link.pose * randomNode(random, 2, k < 20 ? 0.01 : 1);
    const LinkDerivatives<Space> by = derivativesOf(link, i, j);
    for (int axis = 0; axis < 6; ++axis) {
      const Vector6d step = 1e-6 * Vector6d::Unit(axis);
      const Vector6d by_i =
          (residualOf(link, moved(i, step), j) - residualOf(link, moved(i, -step), j)) / 2e-6;
      const Vector6d by_j =
          (residualOf(link, i, moved(j, step)) - residualOf(link, i, moved(j, -step))) / 2e-6;
      CHECK((by_i - by.by_from.col(axis)).norm() < 1e-4 * (1 + by_i.norm()));
      CHECK((by_j - by.by_to.col(axis)).norm() < 1e-4 * (1 + by_j.norm()));
    }
  }
}

TEST_CASE("residual and derivatives are the same in every world frame") {
  RandomStream random(3);
  for (int k = 0; k < 20; ++k) {
    SpatialLink link;
    link.pose = randomNode(random, 5, 1);
    const Eigen::Isometry3d i = randomNode(random, 30, 1.5);
    const Eigen::Isometry3d j = i * link.pose * randomNode(random, 1, 0.3);
    const Eigen::Isometry3d world = randomNode(random, 100, 2);
    CHECK((residualOf(link, world * i, world * j) - residualOf(link, i, j)).norm() < 1e-10);
    const LinkDerivatives<Space> here = derivativesOf(link, i, j);
    const LinkDerivatives<Space> there = derivativesOf(link, world * i, world * j);
    CHECK((there.by_from - here.by_from).norm() < 1e-9 * here.by_from.norm());
  }
}

TEST_CASE("in the plane, a small residual is the planar one in other axes") {
  RandomStream random(4);
  for (int k = 0; k < 20; ++k) {
    const PlanarPose i = {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)};
    PlanarLink planar;
    planar.pose = {random.uniform(0, 3), random.uniform(-1, 1), random.uniform(-1, 1)};
    PlanarPose j = compose(i, planar.pose);
    j = {j.x + 1e-4, j.y - 2e-4, j.theta + 1e-4};
    SpatialLink link;
    link.pose = fromPlanar(planar.pose);
    const Vector6d r = residualOf(link, fromPlanar(i), fromPlanar(j));
    const Eigen::Vector3d expected = residualOf(planar, i, j);
    CHECK(std::abs(r[1]) + std::abs(r[3]) + std::abs(r[5]) < 1e-12);  // height, pitch, roll
    CHECK(-r[4] == Approx(expected.z()).epsilon(1e-6));
    CHECK(std::hypot(r[0], r[2]) == Approx(expected.head<2>().norm()).epsilon(1e-3));
  }
}

}  // namespace tolman::experience_map
