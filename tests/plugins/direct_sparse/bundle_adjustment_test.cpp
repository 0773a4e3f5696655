// SPDX-License-Identifier: BSD-3-Clause
// From disturbed values the window converges to the true ones of the rendered street.
#include "bundle_adjustment.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "street.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

std::vector<Eigen::Isometry3d> poses() {
  return {test::streetPose(0), test::streetPose(0.4, 0.01), test::streetPose(0.8, 0.02),
          test::streetPose(1.2, 0.02)};
}

std::unique_ptr<Window> held() {
  auto window = test::streetWindow(poses());
  test::addTruePoints(*window, 250);
  window->prior.H.diagonal().head<8>().setConstant(1e13);
  window->keyframe(0).has_prior = true;
  window->prior.H.diagonal().tail<kFieldVariables>().setConstant(1e13);
  return window;
}

double worstPosition(const Window& window) {
  double worst = 0;
  for (const int slot : window.order()) {
    const Eigen::Isometry3d truth = poses()[static_cast<std::size_t>(slot)];
    worst = std::max(
        worst, (window.keyframe(slot).T_world_camera().translation() - truth.translation()).norm());
  }
  return worst;
}

AdjustmentSettings settings(int iterations) {
  AdjustmentSettings s;
  s.iterations = iterations;
  return s;
}

}  // namespace

TEST_CASE("poses and depths that are off come back") {
  const auto window = held();
  RandomStream random(2);
  for (const int slot : {1, 2, 3}) {
    Vector6d off;
    for (int i = 0; i < 6; ++i) off[i] = (i < 3 ? 0.02 : 0.002) * random.uniform(-1, 1);
    Keyframe& keyframe = window->keyframe(slot);
    keyframe.T0_camera_world = expSe3(off) * keyframe.T0_camera_world;
    for (Point& point : keyframe.points) {
      point.inverse_depth *= static_cast<float>(random.uniform(0.95, 1.05));
    }
  }
  CHECK(worstPosition(*window) > 0.01);
  LinearSystem system;
  const AdjustmentResult result = adjustWindow(test::streetRig(), settings(15), *window, system);
  CHECK(result.residuals > 1000);
  CHECK(worstPosition(*window) < 0.004);
  CHECK(window->energy_threshold < Window::kFirstThreshold);
}

TEST_CASE("a brightness change is found as a and b") {
  const auto window = held();
  Keyframe& keyframe = window->keyframe(2);
  const GrayLevel bright = keyframe.left.level(0);
  const GrayLevel dark = test::levelOf(bright.width, bright.height, [&](int u, int v) {
    return std::lround(0.8 * bright.row(v)[u] + 10);
  });
  keyframe.left.level(0) = dark;
  keyframe.has_right = false;
  for (Point& point : keyframe.points) {
    point.pattern = patternAt(dark, int(point.u), int(point.v));
    point.stereo = ResidualState::Absent;
  }
  keyframe.affine0 = {-0.15, 5};
  LinearSystem system;
  adjustWindow(test::streetRig(), settings(15), *window, system);
  for (const double level : {60.0, 125.0, 200.0}) {
    const double seen = std::exp(keyframe.affine().a) * level + keyframe.affine().b;
    CHECK(seen == Approx(0.8 * level + 10).margin(3));
  }
  CHECK(worstPosition(*window) < 0.006);
}

TEST_CASE("all lengths wrong by two percent: static stereo knows the scale") {
  const auto window = held();
  for (const int slot : window->order()) {
    Keyframe& keyframe = window->keyframe(slot);
    keyframe.T0_camera_world.translation() *= 1.02;
    for (Point& point : keyframe.points) point.inverse_depth /= 1.02F;
  }
  LinearSystem system;
  adjustWindow(test::streetRig(), settings(20), *window, system);
  CHECK(window->keyframe(3).T_world_camera().translation().norm() == Approx(1.2).epsilon(0.005));
}

TEST_CASE("an offset of all disparities is found when it is let free, and ruins the scale if not") {
  const auto shiftedWindow = [](double hold) {
    auto window = held();
    window->prior.H(kOffsetIndex, kOffsetIndex) = hold;
    window->field.startFrom(-0.5);  // expected, while the images have none
    return window;
  };
  LinearSystem system;
  const auto free_window = shiftedWindow(1e-3);
  adjustWindow(test::streetRig(), settings(20), *free_window, system);
  CHECK(free_window->field.offset() == Approx(0).margin(0.25));
  const auto held_window = shiftedWindow(1e13);
  adjustWindow(test::streetRig(), settings(20), *held_window, system);
  CHECK(held_window->field.offset() == Approx(-0.5));
}

TEST_CASE("points that contradict the images are given up") {
  const auto window = held();
  std::vector<Point>& points = window->keyframe(1).points;
  const std::size_t before = window->pointCount();
  for (std::size_t i = 0; i < points.size(); i += 10) {
    for (float& value : points[i].pattern.value) value = value < 128 ? value + 90 : value - 90;
  }
  LinearSystem system;
  adjustWindow(test::streetRig(), settings(3), *window, system);
  dropOutliers(*window);
  CHECK(window->pointCount() < before);
  CHECK(window->pointCount() > 8 * before / 10);
  for (const int slot : window->order()) {
    for (const Point& point : window->keyframe(slot).points) {
      for (const ResidualState state : point.temporal) {
        CHECK((state == ResidualState::Good || state == ResidualState::Absent));
      }
    }
  }
}

TEST_CASE("first estimates stay put once a prior holds on to them") {
  const auto window = held();
  window->keyframe(1).has_prior = true;
  const Eigen::Isometry3d first = window->keyframe(1).T0_camera_world;
  const Eigen::Isometry3d free_first = window->keyframe(2).T0_camera_world;
  LinearSystem system;
  adjustWindow(test::streetRig(), settings(2), *window, system);
  CHECK(window->keyframe(1).T0_camera_world.matrix() == first.matrix());
  CHECK_FALSE(window->keyframe(1).change.isZero(0));
  CHECK(window->keyframe(2).change.isZero(0));
  CHECK(window->keyframe(2).T0_camera_world.matrix() != free_first.matrix());
}
