// SPDX-License-Identifier: BSD-3-Clause
#include "tolman/geometry.hpp"

#include <catch2/catch.hpp>
#include <unsupported/Eigen/MatrixFunctions>

#include "tolman/context.hpp"

using namespace tolman;

namespace {

Vector6d randomTwist(RandomStream& random) {
  Vector6d twist;
  for (int i = 0; i < 3; ++i) twist[i] = random.uniform(-5, 5);
  Eigen::Vector3d axis(random.normal(), random.normal(), random.normal());
  twist.tail<3>() = axis.normalized() * random.uniform(0, 3.1);
  return twist;
}

}  // namespace

TEST_CASE("angles wrap to half-open intervals") {
  const double pi = std::numbers::pi;
  CHECK(wrapAngle(pi) == Approx(-pi));
  CHECK(wrapAngle(-pi) == Approx(-pi));
  CHECK(wrapAngle(3 * pi + 0.1) == Approx(-pi + 0.1));
  CHECK(wrapPeriod(-0.5, 15) == Approx(14.5));
  CHECK(wrapPeriod(15, 15) == 0);
  CHECK(wrapPeriod(-1e-18, 15) < 15);  // rounding must not reach the period
}

TEST_CASE("expSe3 agrees with the matrix exponential, and logSe3 inverts it") {
  RandomStream random(1);
  for (int i = 0; i < 100; ++i) {
    const Vector6d twist = randomTwist(random);
    Eigen::Matrix4d generator = Eigen::Matrix4d::Zero();
    generator.topLeftCorner<3, 3>() = skew(twist.tail<3>());
    generator.topRightCorner<3, 1>() = twist.head<3>();
    const Eigen::Matrix4d oracle = generator.exp();
    CHECK((expSe3(twist).matrix() - oracle).norm() < 1e-9);
    CHECK((logSe3(expSe3(twist)) - twist).norm() < 1e-8);
  }
}

TEST_CASE("expSe3 is smooth through zero") {
  Vector6d tiny;
  tiny << 1, 2, 3, 1e-12, -1e-12, 1e-12;
  CHECK((expSe3(tiny).translation() - tiny.head<3>()).norm() < 1e-11);
  CHECK(logSe3(Eigen::Isometry3d::Identity()).norm() == 0);
}

TEST_CASE("the adjoint moves a small motion from the right of a pose to its left") {
  Vector6d pose;
  pose << 1, -2, 3, 0.4, -0.2, 0.7;
  Vector6d motion;
  motion << 0.1, 0.2, -0.3, 0.03, 0.02, -0.05;
  const Eigen::Isometry3d T = expSe3(pose);
  CHECK((T * expSe3(motion)).isApprox(expSe3(adjointSe3(T) * motion) * T, 1e-12));
}

TEST_CASE("camera axes and the plane convert as documented") {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << 2, 0.5, 10;  // right 2 m, down 0.5 m, forward 10 m
  const PlanarPose pose = toPlanar(T);
  CHECK(pose.x == 10);
  CHECK(pose.y == -2);
  // A turn to the left moves the optical axis towards -x of the camera.
  T.linear() = Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitY()).toRotationMatrix();
  CHECK(T.linear().col(2).x() < 0);
  CHECK(toPlanar(T).theta == Approx(0.3));
}

TEST_CASE("planar composition agrees with composition in camera axes") {
  RandomStream random(2);
  for (int i = 0; i < 50; ++i) {
    const PlanarPose a{random.normal(), random.normal(), random.uniform(-3, 3)};
    const PlanarPose b{random.normal(), random.normal(), random.uniform(-3, 3)};
    const PlanarPose c = compose(a, b);
    const PlanarPose oracle = toPlanar(fromPlanar(a) * fromPlanar(b));
    CHECK(c.x == Approx(oracle.x));
    CHECK(c.y == Approx(oracle.y));
    CHECK(wrapAngle(c.theta - oracle.theta) == Approx(0).margin(1e-12));
    const PlanarPose back = between(a, c);
    CHECK(back.x == Approx(b.x));
    CHECK(back.y == Approx(b.y));
  }
}

TEST_CASE("random streams are the same on every machine and look uniform") {
  RandomStream a(42);
  RandomStream b(42);
  CHECK(a.bits() == b.bits());
  CHECK(RandomStream(42).bits() != RandomStream(43).bits());
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < 10000; ++i) {
    const double z = a.normal();
    sum += z;
    squares += z * z;
  }
  CHECK(std::abs(sum / 10000) < 0.05);
  CHECK(std::abs(squares / 10000 - 1) < 0.05);
  for (int i = 0; i < 1000; ++i) CHECK(a.below(7) < 7);
}
