// SPDX-License-Identifier: BSD-3-Clause
// Projection against OpenCV's functions, and against the closed form of the mirror.
#include <catch2/catch.hpp>
#include <opencv2/calib3d.hpp>

#include "engine/raw_cameras.hpp"
#include "engine/rectified_view.hpp"

using namespace tolman;
using namespace tolman::engine;

namespace {

std::vector<double> coefficients(const RawCamera& camera, Eigen::Index count) {
  return {camera.distortion.data(), camera.distortion.data() + count};
}

/// By OpenCV.
Eigen::Vector2d projected(const RawCamera& camera, const Eigen::Vector3d& p) {
  const std::vector<cv::Point3d> points = {{p.x(), p.y(), p.z()}};
  const cv::Vec3d none(0, 0, 0);
  std::vector<cv::Point2d> pixels;
  if (camera.model == LensModel::Equidistant) {
    cv::fisheye::projectPoints(points, pixels, none, none, test::matrixOf(camera.pinhole),
                               coefficients(camera, 4));
  } else {
    cv::projectPoints(points, none, none, test::matrixOf(camera.pinhole), coefficients(camera, 8),
                      pixels);
  }
  return {pixels[0].x, pixels[0].y};
}

}  // namespace

TEST_CASE("points are projected as OpenCV projects them") {
  const RawCamera camera =
      GENERATE(test::eurocCamera(), test::fisheyeCamera(), test::rationalCamera());
  const Lens lens(camera);
  int inside = 0;
  for (int x = -10; x <= 10; ++x) {
    for (int y = -6; y <= 6; ++y) {
      const Eigen::Vector3d point(0.13 * x, 0.13 * y, 1.7);
      const auto pixel = lens.project(point);
      REQUIRE(pixel);
      CHECK((*pixel - projected(camera, point)).norm() < 1e-9);
      inside += lens.pixelOf(point) ? 1 : 0;
    }
  }
  CHECK(inside > 60);
}

TEST_CASE("the omnidirectional model is a projection from a shifted centre of the unit sphere") {
  RawCamera camera = test::omnidirectionalCamera();
  camera.distortion.setZero();
  const Lens lens(camera);
  const Eigen::Vector3d point(0.8, -0.5, 0.4);
  const Eigen::Vector3d s = point.normalized();
  const Pinhole& K = camera.pinhole;
  const Eigen::Vector2d expected = K.project({s.x(), s.y(), s.z() + 1.2});
  CHECK((*lens.project(point) - expected).norm() < 1e-9);
  CHECK((*lens.project(7 * point) - expected).norm() < 1e-9);
  // With distortion: that of the radial-tangential model, of the same point of the plane.
  const RawCamera distorted = test::omnidirectionalCamera();
  RawCamera plane = distorted;
  plane.model = LensModel::RadialTangential;
  const Eigen::Vector3d on_plane(s.x() / (s.z() + 1.2), s.y() / (s.z() + 1.2), 1);
  CHECK((*Lens(distorted).project(point) - projected(plane, on_plane)).norm() < 1e-9);
}

TEST_CASE("rays beyond the turning point of the polynomial have no pixel") {
  // r (1 - 0.25 r^2) is largest at r = sqrt(4/3) = 1.155, where it is 0.770.
  const RawCamera camera =
      test::rawCamera(LensModel::RadialTangential, 1000, 1000, {300, 300, 500, 500}, {-0.25});
  const Lens lens(camera);
  CHECK(lens.pixelOf({1.15, 0, 1}).has_value());
  CHECK_FALSE(lens.project({1.16, 0, 1}).has_value());  // OpenCV gives a pixel in the image here
  CHECK(projected(camera, {1.16, 0, 1}).x() < 1000);
  CHECK_FALSE(lens.project({0, 0, -1}).has_value());
  CHECK_FALSE(Lens(test::eurocCamera()).pixelOf({1.2, 0, 1}).has_value());  // outside of the image
}

TEST_CASE("a fisheye has pixels beyond 90 degrees") {
  CHECK(Lens(test::fisheyeCamera()).pixelOf({1, 1, -0.02}).has_value());
}

TEST_CASE("the focal length at the centre is that of small angles") {
  for (const RawCamera& camera : {test::eurocCamera(), test::fisheyeCamera(),
                                  test::omnidirectionalCamera(), test::rationalCamera()}) {
    const Lens lens(camera);
    const double step = 1e-5;
    const double measured =
        (*lens.project({step, 0, 1}) - *lens.project({-step, 0, 1})).norm() / (2 * step);
    CHECK(lens.focal() == Approx(measured).epsilon(0.002));
  }
  CHECK(Lens(RawCamera()).isPinhole());
  CHECK_FALSE(Lens(test::eurocCamera()).isPinhole());
}
