// SPDX-License-Identifier: BSD-3-Clause
// Stereo projection against closed forms and finite differences.
#include "projection.hpp"

#include <catch2/catch.hpp>

#include "support/street_scene.hpp"

using namespace tolman;
using namespace tolman::feature_stereo;

namespace {

InverseDepthPoint somePoint() {
  InverseDepthPoint point;
  point.T_world_reference = expSe3((Vector6d() << 1, -2, 3, 0.1, -0.2, 0.05).finished());
  point.coordinates << 0.2, -0.1, 1 / 12.0;
  return point;
}

const Eigen::Isometry3d kCamera = expSe3((Vector6d() << 1.5, -1.9, 4, 0.12, -0.1, 0.02).finished());

}  // namespace

TEST_CASE("triangulation is depth = focal length * baseline / disparity") {
  const CameraRig rig = test::streetRig();
  const Eigen::Vector3d p(2, -1, 10);  // in the camera
  const Eigen::Vector2d left = rig.pinhole.project(p);
  const Eigen::Vector2d right = rig.pinhole.project(p - Eigen::Vector3d(rig.baseline, 0, 0));
  const Eigen::Vector3d c = triangulate(rig, {left.x(), left.y(), left.x() - right.x()});
  CHECK((Eigen::Vector3d(c.x(), c.y(), 1) / c.z() - p).norm() < 1e-12);
}

TEST_CASE("projection inverts triangulation and agrees with the pinhole elsewhere") {
  const CameraRig rig = test::streetRig();
  const InverseDepthPoint point = somePoint();
  const auto at_reference = project(rig, point.T_world_reference, point);
  REQUIRE(at_reference);
  CHECK((triangulate(rig, *at_reference) - point.coordinates).norm() < 1e-12);

  const Eigen::Vector3d world = point.T_world_reference * (Eigen::Vector3d(0.2, -0.1, 1) * 12.0);
  const Eigen::Vector3d p = kCamera.inverse() * world;
  const auto pixel = project(rig, kCamera, point);
  REQUIRE(pixel);
  CHECK((pixel->head<2>() - rig.pinhole.project(p)).norm() < 1e-9);
  CHECK(pixel->z() == Approx(rig.pinhole.fx * rig.baseline / p.z()));
}

TEST_CASE("a point at infinity is seen in its direction, with no disparity") {
  const CameraRig rig = test::streetRig();
  InverseDepthPoint point = somePoint();
  point.coordinates.z() = 0;
  const auto pixel = project(rig, kCamera, point);
  REQUIRE(pixel);
  CHECK(pixel->z() == 0);
  const Eigen::Vector3d direction = kCamera.linear().transpose() *
                                    point.T_world_reference.linear() *
                                    Eigen::Vector3d(0.2, -0.1, 1);
  CHECK((pixel->head<2>() - rig.pinhole.project(direction)).norm() < 1e-9);
}

TEST_CASE("nothing behind the camera is seen") {
  const Eigen::Isometry3d beyond(Eigen::Translation3d(0, 0, 30));
  InverseDepthPoint point;
  point.coordinates << 0, 0, 0.1;
  CHECK_FALSE(project(test::streetRig(), beyond, point));
}

TEST_CASE("projection's derivatives agree with finite differences") {
  const CameraRig rig = test::streetRig();
  const InverseDepthPoint point = somePoint();
  ProjectionJacobians J;
  REQUIRE(project(rig, kCamera, point, &J));
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 6; ++k) {
    const Vector6d step = kStep * Vector6d::Unit(k);
    const Eigen::Vector3d slope = (*project(rig, kCamera * expSe3(step), point) -
                                   *project(rig, kCamera * expSe3(-step), point)) /
                                  (2 * kStep);
    CHECK((slope - J.pose.col(k)).norm() < 1e-4 * (1 + slope.norm()));
  }
  for (int k = 0; k < 3; ++k) {
    InverseDepthPoint more = point;
    InverseDepthPoint less = point;
    more.coordinates[k] += kStep;
    less.coordinates[k] -= kStep;
    const Eigen::Vector3d slope =
        (*project(rig, kCamera, more) - *project(rig, kCamera, less)) / (2 * kStep);
    CHECK((slope - J.point.col(k)).norm() < 1e-4 * (1 + slope.norm()));
  }
}

TEST_CASE("noise grows with disparity, and the covariance is that of inverse depth") {
  const PixelNoise noise{0.3, 0.2, 10};
  CHECK(noise.sigma(0).isApprox(Eigen::Vector3d(0.3, 0.3, 0.2)));
  CHECK(noise.sigma(10).isApprox(std::sqrt(2.0) * noise.sigma(0)));
  const CameraRig rig = test::streetRig();
  const Eigen::Matrix3d covariance = triangulationCovariance(rig, noise.sigma(0));
  CHECK(std::sqrt(covariance(2, 2)) == Approx(0.2 / (300 * 0.5)));
  CHECK(std::sqrt(covariance(0, 0)) == Approx(0.3 / 300));
}
