// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of the residuals against finite differences.
#include "photometric_residual.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

/// A pair of keyframes on an image of slope 1 in u and v around the point, so that bilinear values
/// are exact and the residual is smooth; r is within the Huber norm's square part.
struct Smooth {
  std::unique_ptr<Window> window = std::make_unique<Window>();
  CameraRig rig = test::streetRig();

  Smooth() {
    for (int k = 0; k < 2; ++k) {
      Keyframe& keyframe = window->add();
      keyframe.frame = k;
      const GrayLevel level = test::levelOf(480, 200, [](int u, int v) {
        return std::clamp(u - 90, 0, 130) + std::clamp(v - 60, 0, 120);
      });
      keyframe.left.level(0) = level;
    }
    window->keyframe(0).T0_camera_world = test::streetPose(0, 0.02).inverse();
    window->keyframe(1).T0_camera_world = test::streetPose(0.4, -0.01).inverse();
    window->keyframe(0).affine0 = {0.05, 2};
    window->keyframe(1).affine0 = {-0.03, 1};
  }
  Keyframe& host() { return window->keyframe(0); }
  Keyframe& target() { return window->keyframe(1); }
  Point point() {
    Point p;
    p.u = 150;
    p.v = 120;
    p.inverse_depth = 0.12F;
    p.pattern = patternAt(host().left.level(0), 150, 120);
    return p;
  }
  PairGeometry pair() { return pairGeometry(rig.pinhole, host(), target()); }

  /// Pixel of the pattern's centre in the target.
  Eigen::Vector2d pixel(double inverse_depth) {
    const Eigen::Vector3d ray = rig.pinhole.ray({150, 120});
    return rig.pinhole.project(target().T_camera_world() * host().T_world_camera() *
                               (ray / inverse_depth));
  }
};

Vector8d unit(int i, double size) { return size * Vector8d::Unit(i); }

}  // namespace

TEST_CASE("the centre's pixel moves with pose and depth as its derivatives say") {
  Smooth s;
  const CentreJacobian J = centreJacobian(s.rig.pinhole, s.pair(), 150, 120, 0.12F);
  constexpr double h = 1e-5;
  for (int i = 0; i < 6; ++i) {
    s.target().change = unit(i, h);
    const Eigen::Vector2d plus = s.pixel(0.12);
    s.target().change = unit(i, -h);
    const Eigen::Vector2d slope = (plus - s.pixel(0.12)) / (2 * h);
    s.target().change.setZero();
    CAPTURE(i);
    CHECK(J.u_by_twist[static_cast<std::size_t>(i)] ==
          Approx(slope.x()).epsilon(1e-3).margin(0.01));
    CHECK(J.v_by_twist[static_cast<std::size_t>(i)] ==
          Approx(slope.y()).epsilon(1e-3).margin(0.01));
  }
  const Eigen::Vector2d slope = (s.pixel(0.12 + h) - s.pixel(0.12 - h)) / (2 * h);
  CHECK(J.u_by_depth == Approx(slope.x()).epsilon(1e-3));
  CHECK(J.v_by_depth == Approx(slope.y()).epsilon(1e-3));
}

TEST_CASE("relative variables follow those of host and target") {
  Smooth s;
  const PairGeometry pair = s.pair();
  constexpr double h = 1e-6;
  const auto relative = [&] {
    const Eigen::Isometry3d T = s.target().T_camera_world() * s.host().T_world_camera();
    const Eigen::Isometry3d T0 = s.target().T0_camera_world * s.host().T0_camera_world.inverse();
    return logSe3(T * T0.inverse());
  };
  for (int i = 0; i < 6; ++i) {
    s.host().change = unit(i, h);
    const Vector6d slope = relative() / h;
    s.host().change.setZero();
    const Vector6d expected = pair.relative_by_host.cast<double>().block<6, 1>(0, i);
    CAPTURE(i);
    CHECK((slope - expected).norm() < 1e-4);
  }
}

TEST_CASE("gradients of the energy agree with finite differences of all variables") {
  Smooth s;
  Point point = s.point();
  PixelSums sums;
  REQUIRE(test::sumsIn(s.pair(), s.target().left.level(0), point, sums));
  for (float& value : point.pattern.value) value += sums.r1 / sums.w - 3;  // now off by about 3
  REQUIRE(test::sumsIn(s.pair(), s.target().left.level(0), point, sums));
  REQUIRE(sums.energy > 1);
  REQUIRE(sums.energy < 8 * kHuber * kHuber);  // all residuals in the square part
  const CentreJacobian J = centreJacobian(s.rig.pinhole, s.pair(), point.u, point.v, 0.12F);
  const auto energy = [&](const Point& p) {
    PixelSums e;
    REQUIRE(test::sumsIn(s.pair(), s.target().left.level(0), p, e));
    return static_cast<double>(e.energy);
  };
  // The energy is the sum of w r^2, so half its slope is the sum of w J r.
  Vector8d relative;
  for (int i = 0; i < 6; ++i) {
    const auto k = static_cast<std::size_t>(i);
    relative[i] = J.u_by_twist[k] * sums.xr + J.v_by_twist[k] * sums.yr;
  }
  relative[6] = sums.ar;
  relative[7] = -sums.r1;
  const Vector8d by_host = s.pair().relative_by_host.cast<double>().transpose() * relative;
  for (int i = 0; i < 8; ++i) {
    const double h = i < 3 ? 2e-2 : i < 6 ? 2e-3 : i == 6 ? 1e-2 : 0.2;
    for (Keyframe* moved : {&s.target(), &s.host()}) {
      moved->change = unit(i, h);
      const double plus = energy(point);
      moved->change = unit(i, -h);
      const double slope = (plus - energy(point)) / (4 * h);
      moved->change.setZero();
      const double expected = moved == &s.target() ? relative[i] : by_host[i];
      CAPTURE(i, moved == &s.target());
      // First-estimate derivatives ignore that the pattern turns and grows.
      CHECK(expected == Approx(slope).epsilon(0.15).margin(0.02 * relative.cwiseAbs().maxCoeff()));
    }
  }
  Point moved = point;
  moved.inverse_depth = 0.13F;
  const double plus = energy(moved);
  moved.inverse_depth = 0.11F;
  const double slope = (plus - energy(moved)) / 0.04;
  CHECK(J.u_by_depth * sums.xr + J.v_by_depth * sums.yr == Approx(slope).epsilon(0.15));
}

TEST_CASE("sums are those of a plain loop over the pattern") {
  Smooth s;
  const Point point = s.point();
  const PairGeometry pair = s.pair();
  PixelSums sums;
  REQUIRE(test::sumsIn(pair, s.target().left.level(0), point, sums));
  const Eigen::Isometry3d T = s.target().T_camera_world() * s.host().T_world_camera();
  double xx = 0, xr = 0, ar = 0, w1 = 0, energy = 0;
  for (std::size_t k = 0; k < kPatternSize; ++k) {
    const Eigen::Vector3d ray = s.rig.pinhole.ray({150.0 + kPatternU[k], 120.0 + kPatternV[k]});
    const Eigen::Vector2d q = s.rig.pinhole.project(T * (ray / 0.12));
    const GrayLevel& image = s.target().left.level(0);
    const auto x = static_cast<float>(q.x());
    const auto y = static_cast<float>(q.y());
    const double value = image.at(x, y);
    const double gx = 0.5 * (image.at(x + 1, y) - image.at(x - 1, y));
    const double gain = std::exp(-0.08);
    const double scene = gain * (point.pattern.value[k] - 2);
    const double r = value - scene - 1;
    const double huber = std::min(1.0, kHuber / std::abs(r));
    const double w = point.pattern.weight[k] * huber;
    xx += w * gx * gx;
    xr += w * gx * r;
    ar += -w * scene * r;
    w1 += w;
    energy += w * (2 - huber) * r * r;
  }
  CHECK(sums.xx == Approx(xx).epsilon(1e-3));
  CHECK(sums.xr == Approx(xr).epsilon(1e-2));
  CHECK(sums.ar == Approx(ar).epsilon(1e-2));
  CHECK(sums.w == Approx(w1).epsilon(1e-3));
  CHECK(sums.energy == Approx(energy).epsilon(1e-2));
}

TEST_CASE("points out of the image or behind the camera are not seen") {
  Smooth s;
  Point point = s.point();
  PixelSums sums;
  point.inverse_depth = 3;  // behind the target
  CHECK_FALSE(test::sumsIn(s.pair(), s.target().left.level(0), point, sums));
  point = s.point();
  point.u = 3;
  s.target().change[4] = -0.2;
  CHECK_FALSE(test::sumsIn(s.pair(), s.target().left.level(0), point, sums));
}

TEST_CASE("the static residual: derivative by disparity, and the edge of the right image") {
  const GrayLevel right = test::levelOf(480, 200, [](int u, int) { return u / 2; });
  const GrayLevel left = test::levelOf(480, 200, [](int u, int) { return (u - 30) / 2; });
  Point point;
  point.u = 200;
  point.v = 100;
  point.pattern = patternAt(left, 200, 100);
  StereoGeometry stereo{150, 0, 1, 0};  // 30 px at 5 m
  const auto at = [&](float inverse_depth) {
    point.inverse_depth = inverse_depth;
    PixelSums sums;
    REQUIRE(stereoSums(stereo, right, point, sums));
    return sums;
  };
  const PixelSums sums = at(0.18F);  // 27 px: 3 px, or 1.5 grey levels off
  const double slope = (at(0.19F).energy - at(0.17F).energy) / 0.04;
  CHECK(-150 * sums.xr == Approx(slope).epsilon(0.1));
  CHECK(-150 * sums.xr / (150.0 * 150.0 * sums.xx) == Approx(-(0.2 - 0.18)).epsilon(0.35));
  stereo.offset = 3;
  CHECK(at(0.22F).energy == Approx(at(0.22F).energy));
  point.inverse_depth = 1.34F;  // beyond the left edge of the right image
  PixelSums none;
  CHECK_FALSE(stereoSums(stereo, right, point, none));
}
