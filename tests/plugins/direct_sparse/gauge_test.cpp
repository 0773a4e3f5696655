// SPDX-License-Identifier: BSD-3-Clause
// The pose of the whole window is unobservable: it must not drift, also on a long drive.
#include <catch2/catch.hpp>
#include <cmath>

#include "bundle_adjustment.hpp"
#include "harness.hpp"
#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

std::unique_ptr<Window> drive(std::size_t count) {
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t k = 0; k < count; ++k) {
    poses.push_back(test::streetPose(0.6 * static_cast<double>(k), 0.01 * static_cast<double>(k)));
  }
  auto window = test::streetWindow(poses);
  test::addTruePoints(*window, 120);
  window->prior.H.diagonal().tail<kFieldVariables>().setConstant(1e4);
  return window;
}

/// A window of three keyframes whose prior comes from a fourth one that has left.
std::unique_ptr<Window> worn(LinearSystem& system) {
  auto window = drive(4);
  system.build(test::streetRig(), {1.0F}, *window, allPoints(*window));
  system.storeInformation(*window);
  for (Point& point : window->keyframe(0).points) point.seen_good = 3;
  marginalisePoints(test::streetRig(), {1.0F}, {0}, 0.06, *window, system);
  marginaliseKeyframe(0, *window);
  return window;
}

/// Changes of all variables when the world is moved by a small twist: by definition, not by
/// formula.
SystemVector worldMoved(const Window& window, const Vector6d& direction) {
  constexpr double kStep = 1e-6;
  SystemVector x = SystemVector::Zero();
  for (const int slot : window.order()) {
    const Eigen::Isometry3d& T = window.keyframe(slot).T0_camera_world;
    x.segment<6>(kFrameVariables * slot) =
        logSe3(T * expSe3(kStep * direction) * T.inverse()) / kStep;
  }
  return x;
}

/// The same for a scene that is seen brighter by all: e^a I + b with b + e^a each.
SystemVector sceneBrightened(const Window& window) {
  SystemVector x = SystemVector::Zero();
  for (const int slot : window.order()) {
    x[kFrameVariables * slot + 7] = std::exp(window.keyframe(slot).affine0.a);
  }
  return x;
}

/// What is left of the start after a long drive: hardly anything, and that is rounding.
void wearOut(Window& window) {
  for (const int slot : window.order()) {
    const int i = kFrameVariables * slot;
    window.prior.H.diagonal().segment<3>(i).array() += 1;
    window.prior.b.segment<3>(i).array() -= 20;
  }
}

double farthest(const Window& window, const SystemVector& step) {
  double metres = 0;
  for (const int slot : window.order()) {
    metres = std::max(metres, step.segment<3>(kFrameVariables * slot).norm());
  }
  return metres;
}

}  // namespace

TEST_CASE("a start that is worn out does not let the window jump") {
  LinearSystem system;
  const auto window = worn(system);
  system.build(test::streetRig(), {1.0F}, *window, allPoints(*window));
  const SystemVector before = solve(*window, system.H(), system.b());
  wearOut(*window);
  const SystemVector step = solve(*window, system.H(), system.b());
  CHECK(farthest(*window, step) < 0.02);
  CHECK((step - before).norm() < 1e-3);
  CHECK(step.segment<8>(kFrameVariables * window->order().front()).isZero(0));
}

TEST_CASE("a forgotten gauge: no world's motion and no brightness costs anything, the rest stays") {
  LinearSystem system;
  const auto window = worn(system);
  const SystemMatrix exact = window->prior.H;
  const int anchor = kFrameVariables * window->order().front();
  window->prior.H.block<8, 8>(anchor, anchor).diagonal().array() -= 50;
  window->prior.b.segment<8>(anchor).array() += 7;
  projectOutGauge(*window);
  const SystemMatrix& H = window->prior.H;
  CHECK(H.isApprox(H.transpose(), 1e-12));
  for (int i = 0; i < 7; ++i) {
    const SystemVector N =
        i < 6 ? worldMoved(*window, Vector6d::Unit(i)) : sceneBrightened(*window);
    const double own = N.dot(SystemMatrix(H.diagonal().asDiagonal()) * N);
    CAPTURE(i, own);
    CHECK(std::abs(N.dot(H * N)) < 1e-7 * own + 1e-9);
    CHECK(std::abs(N.dot(window->prior.b)) < 1e-5 * window->prior.b.norm() * N.norm() + 1e-9);
  }
  // What the keyframes say of each other is that of the points.
  const int second = kFrameVariables * window->order()[1];
  CHECK(H.block(second, second, 8, 8) == exact.block(second, second, 8, 8));
  CHECK(H.block<6, 6>(anchor, anchor).isApprox(exact.block<6, 6>(anchor, anchor), 1e-3));
}

TEST_CASE("an adjustment tells how far it has moved a keyframe") {
  const auto window = drive(3);
  LinearSystem system;
  AdjustmentSettings settings;
  settings.iterations = 10;
  CHECK(adjustWindow(test::streetRig(), settings, *window, system).metres < 0.005);
  Keyframe& newest = window->newest();
  const Eigen::Isometry3d off(Eigen::Translation3d(0.03, 0, 0));
  newest.T0_camera_world = off * newest.T0_camera_world;
  const AdjustmentResult result = adjustWindow(test::streetRig(), settings, *window, system);
  CHECK(result.metres == Approx(0.03).margin(0.005));
  CHECK(result.radians < 0.005);
}

TEST_CASE("a window that moves too far is a loss that is told, predicted and survived") {
  test::Host host(test::streetRig(), {{"largest_adjustment", 1e-7}});  // no adjustment is so small
  int lost = 0;
  int tracked = 0;
  for (int k = 0; k < 16; ++k) {
    const Motion motion = host.track(test::streetFrame(k, test::streetPose(0.3 * k)));
    if (k == 0) continue;
    lost += motion.state == TrackingState::Lost ? 1 : 0;
    tracked += motion.state == TrackingState::Tracking ? 1 : 0;
    if (motion.state == TrackingState::Lost) {
      CHECK(motion.tracked == 0);
      CHECK(std::sqrt(motion.covariance(2, 2)) > 0.1);
    }
    if (tracked > 0) CHECK(motion.T_previous_current.translation().z() == Approx(0.3).margin(0.06));
  }
  CHECK(lost > 0);
  CHECK(tracked > lost);
  REQUIRE_FALSE(host.log().empty());
  CHECK(host.log().front().find("a new window is started") != std::string::npos);
  host.finish();
  const Eigen::Isometry3d end = host.trajectory().back();
  CHECK(end.translation().z() == Approx(0.3 * 15).margin(0.2));
}
