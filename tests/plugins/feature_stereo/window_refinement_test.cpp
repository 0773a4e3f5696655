// SPDX-License-Identifier: BSD-3-Clause
// Window book-keeping and its refinement, on windows whose truth is known.
#include "window_refinement.hpp"

#include <catch2/catch.hpp>

#include "plugins/feature_stereo/catch_check.hpp"
#include "support/street_scene.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::feature_stereo;

namespace {

Eigen::Isometry3d truePose(int k) {
  return expSe3((Vector6d() << 0.05 * k, 0, 1.0 * k, 0, 0.02 * k, 0).finished());
}

/// Five keyframes that see 150 points, with disparities off by `offset` and this much noise.
Window makeWindow(double noise, double offset) {
  const CameraRig rig = test::streetRig();
  RandomStream random(11);
  Window window;
  for (int k = 0; k < 5; ++k) window.addKeyframe({10 * k, truePose(k)});
  for (int i = 0; i < 150; ++i) {
    Landmark landmark;
    landmark.point.coordinates << random.uniform(-0.6, 0.6), random.uniform(-0.3, 0.3),
        1 / random.uniform(7, 80);
    for (int k = 0; k < 5; ++k) {
      Observation seen{10 * k, *project(rig, truePose(k), landmark.point), i % 4 != 0};
      const Eigen::Vector3d unit(random.normal(), random.normal(), random.normal());
      seen.pixel += noise * unit + Eigen::Vector3d(0, 0, offset);
      landmark.observations.push_back(seen);
    }
    window.addLandmark(landmark);
  }
  return window;
}

/// Moves all but the first keyframe and all points a little.
void disturb(Window& window) {
  RandomStream random(12);
  for (std::size_t k = 1; k < window.keyframes().size(); ++k) {
    Vector6d twist;
    for (double& value : twist) value = 0.005 * random.normal();
    auto& T = window.keyframes()[k].T_world_camera;
    T = T * expSe3(twist);
  }
  for (auto& [id, landmark] : window.landmarks()) {
    landmark.point.coordinates.z() *= 1 + 0.02 * random.normal();
  }
}

double worstTranslation(const Window& window) {
  double worst = 0;
  for (const Keyframe& keyframe : window.keyframes()) {
    const Eigen::Isometry3d truth = truePose(static_cast<int>(keyframe.frame / 10));
    worst = std::max(worst, (truth.inverse() * keyframe.T_world_camera).translation().norm());
  }
  return worst;
}

}  // namespace

TEST_CASE("the cost function's derivatives agree with finite differences") {
  const CameraRig rig = test::streetRig();
  const Observation seen{0, {250, 90, 12}, true};
  const Eigen::Isometry3d reference = truePose(1);
  const StereoReprojection cost(rig, reference, seen, {});
  const PoseManifold manifold;
  const PoseBlock pose = toBlock(truePose(2));
  const Eigen::Vector3d point(0.1, -0.05, 0.08);
  const double offset = 0.1;
  const double* parameters[] = {pose.data(), point.data(), &offset};
  Eigen::Vector3d residual;
  Eigen::Matrix<double, 3, 7, Eigen::RowMajor> by_pose;
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> by_point;
  Eigen::Vector3d by_offset;
  double* jacobians[] = {by_pose.data(), by_point.data(), by_offset.data()};
  REQUIRE(cost.Evaluate(parameters, residual.data(), jacobians));
  CHECK(by_pose.col(6).isZero());

  constexpr double kStep = 1e-6;
  const auto at = [&](int block, int k, double step) {
    PoseBlock moved = pose;
    const Vector6d twist = Vector6d::Unit(block == 0 ? k : 0) * (block == 0 ? step : 0.0);
    manifold.Plus(pose.data(), twist.data(), moved.data());
    Eigen::Vector3d shifted = point;
    if (block == 1) shifted[k] += step;
    const double off = offset + (block == 2 ? step : 0);
    const double* blocks[] = {moved.data(), shifted.data(), &off};
    Eigen::Vector3d r;
    REQUIRE(cost.Evaluate(blocks, r.data(), nullptr));
    return r;
  };
  const auto compare = [&](int block, int k, const Eigen::Vector3d& analytic) {
    const Eigen::Vector3d slope = (at(block, k, kStep) - at(block, k, -kStep)) / (2 * kStep);
    CHECK((slope - analytic).norm() < 1e-4 * (1 + slope.norm()));
  };
  for (int k = 0; k < 6; ++k) compare(0, k, by_pose.col(k));
  for (int k = 0; k < 3; ++k) compare(1, k, by_point.col(k));
  compare(2, 0, by_offset);
}

TEST_CASE("a pose block and its manifold are consistent") {
  const Eigen::Isometry3d T = truePose(3);
  CHECK(fromBlock(toBlock(T).data()).isApprox(T, 1e-12));
  const PoseManifold manifold;
  const Vector6d twist = (Vector6d() << 0.1, -0.2, 0.3, 0.02, 0.01, -0.03).finished();
  PoseBlock moved;
  const PoseBlock start = toBlock(T);
  manifold.Plus(start.data(), twist.data(), moved.data());
  Vector6d back;
  manifold.Minus(moved.data(), start.data(), back.data());
  CHECK(back.isApprox(twist, 1e-9));
}

TEST_CASE("a disturbed window goes back to the truth") {
  Window window = makeWindow(0, 0);
  disturb(window);
  RefinementSettings settings;
  settings.iterations = 30;
  settings.offset_sigma = 0;
  refineWindow(test::streetRig(), settings, window);
  CHECK(worstTranslation(window) < 1e-3);
  CHECK(window.landmarks().size() == 150);
  CHECK(window.keyframes().front().T_world_camera.matrix() == truePose(0).matrix());
}

TEST_CASE("a common error of all disparities is found, and does not scale the motion") {
  RefinementSettings settings;
  settings.iterations = 30;
  settings.offset_drift = 1;
  Window window = makeWindow(0.05, 0.3);
  refineWindow(test::streetRig(), settings, window);
  CHECK(window.disparityOffset() == Approx(0.3).margin(0.05));
  CHECK(worstTranslation(window) < 0.02);

  Window trusting = makeWindow(0.05, 0.3);
  settings.offset_sigma = 0;
  refineWindow(test::streetRig(), settings, trusting);
  CHECK(trusting.disparityOffset() == 0);
  CHECK(worstTranslation(trusting) > 0.02);
}

TEST_CASE("an observation that does not fit is removed, its landmark stays") {
  Window window = makeWindow(0.05, 0);
  window.find(7)->observations[2].pixel.x() += 30;
  RefinementSettings settings;
  settings.iterations = 20;
  refineWindow(test::streetRig(), settings, window);
  REQUIRE(window.find(7) != nullptr);
  CHECK(window.find(7)->observations.size() == 4);
  CHECK(worstTranslation(window) < 0.02);
}

TEST_CASE("the same window gives the same bits, wherever it lies in memory") {
  Window first = makeWindow(0.2, 0.1);
  const std::vector<int> gap(100'003);
  Window second = makeWindow(0.2, 0.1);
  refineWindow(test::streetRig(), {}, first);
  refineWindow(test::streetRig(), {}, second);
  for (std::size_t k = 0; k < first.keyframes().size(); ++k) {
    CHECK(first.keyframes()[k].T_world_camera.matrix() ==
          second.keyframes()[k].T_world_camera.matrix());
  }
  CHECK(first.disparityOffset() == second.disparityOffset());
}

TEST_CASE("dropping the oldest keyframe drops what it alone saw") {
  Window window;
  window.addKeyframe({0, truePose(0)});
  window.addKeyframe({3, truePose(1)});
  Landmark once;
  once.observations = {{0, StereoPixel::Zero(), true}};
  Landmark twice;
  twice.observations = {{0, StereoPixel::Zero(), true}, {3, StereoPixel::Zero(), true}};
  const std::int64_t lost = window.addLandmark(once);
  const std::int64_t kept = window.addLandmark(twice);
  window.dropOldest();
  CHECK(window.keyframes().size() == 1);
  CHECK(window.find(lost) == nullptr);
  REQUIRE(window.find(kept) != nullptr);
  CHECK(window.find(kept)->observations.size() == 1);
}
