// SPDX-License-Identifier: BSD-3-Clause
// One camera on the rendered street: the shape of the drive, without its scale.
#include <catch2/catch.hpp>
#include <cmath>

#include "harness.hpp"
#include "street.hpp"

using namespace tolman;

namespace {

Frame leftAt(int k, const Eigen::Isometry3d& T_world_camera) {
  Frame frame = test::streetFrame(k, T_world_camera);
  frame.right = Image();
  return frame;
}

Frame streetLeft(int k, double step) { return leftAt(k, test::streetPose(step * k, 0.004 * k)); }

/// Straight on for `straight` frames of half a metre, then a turn of 4 degrees a frame.
Eigen::Isometry3d turningPose(int k, int straight) {
  if (k <= straight) return test::streetPose(0.5 * k);
  constexpr double kRadius = 3.6;  // m
  const double angle = 0.07 * (k - straight);
  Eigen::Isometry3d pose = test::streetPose(0.5 * straight + kRadius * std::sin(angle), angle);
  pose.translation().x() = kRadius * (1 - std::cos(angle));
  return pose;
}

CameraRig oneCamera() {
  CameraRig rig = test::streetRig();
  rig.baseline = 0;
  return rig;
}

}  // namespace

TEST_CASE("a single camera starts within a few frames and keeps one scale") {
  test::Host host(oneCamera(), {{"camera_height", 1.5}}, direct_sparse::Cameras::Single);
  REQUIRE(host.configured().isOk());
  int first_tracked = -1;
  const int count = 26;
  for (int k = 0; k < count; ++k) {
    const Motion motion = host.track(streetLeft(k, 0.25));
    CHECK_FALSE(motion.scale_known);
    CHECK(motion.state != TrackingState::Lost);
    if (motion.state == TrackingState::Initialising) {
      CHECK(first_tracked < 0);
      CHECK(motion.T_previous_current.matrix().isIdentity(0));
    } else if (first_tracked < 0) {
      first_tracked = k;
    }
  }
  host.finish();
  CHECK(first_tracked > 0);
  CHECK(first_tracked < 15);
  const auto poses = host.trajectory();
  // Steps are equal, whatever their length is.
  const double whole = (poses[25].translation() - poses[0].translation()).norm();
  const double half = (poses[25].translation() - poses[13].translation()).norm();
  CHECK(half / whole == Approx(12.0 / 25).epsilon(0.03));
  CHECK(logSo3(poses[25].linear()).norm() == Approx(0.1).epsilon(0.05));
  CHECK(whole > 0.25 * 25 * 0.25);  // arbitrary, but of the draft's order
  CHECK(whole < 4 * 25 * 0.25);
}

TEST_CASE("a single camera starts at full speed, too") {
  test::Host host(oneCamera(), {{"camera_height", 1.5}}, direct_sparse::Cameras::Single);
  const int count = 24;
  for (int k = 0; k < count; ++k) {
    const Motion motion = host.track(streetLeft(k, 1.3));
    CHECK((motion.state == TrackingState::Tracking) == (k > 2));
  }
  host.finish();
  const auto poses = host.trajectory();
  const double whole = (poses[23].translation() - poses[0].translation()).norm();
  const double half = (poses[23].translation() - poses[12].translation()).norm();
  CHECK(half / whole == Approx(11.0 / 23).epsilon(0.03));
}

TEST_CASE("a single camera finds new depths in a sharp turn, where every frame is a keyframe") {
  test::Host host(oneCamera(), {{"camera_height", 1.5}, {"keyframe_weight", 3.0}},
                  direct_sparse::Cameras::Single);
  const int straight = 14;
  const int count = straight + 19;
  int keyframes = 0;
  for (int k = 0; k < count; ++k) {
    const Motion motion = host.track(leftAt(k, turningPose(k, straight)));
    CHECK(motion.state != TrackingState::Lost);
    keyframes += k > straight && motion.is_keyframe ? 1 : 0;
  }
  host.finish();
  CHECK(keyframes == count - 1 - straight);
  const auto poses = host.trajectory();
  const double before = (poses[14].translation() - poses[4].translation()).norm() / 5;
  const double chord = (poses[32].translation() - poses[22].translation()).norm();
  const double true_chord =
      (turningPose(32, straight).translation() - turningPose(22, straight).translation()).norm();
  CHECK(chord / before == Approx(true_chord).epsilon(0.05));
  CHECK(logSo3(poses[32].linear()).norm() == Approx(0.07 * 18).epsilon(0.02));
}

TEST_CASE("a single camera that stands still has nothing to say") {
  test::Host host(oneCamera(), {}, direct_sparse::Cameras::Single);
  for (int k = 0; k < 8; ++k) {
    const Motion motion = host.track(test::again(streetLeft(0, 0), k));
    CHECK(motion.state == TrackingState::Initialising);
  }
}

TEST_CASE("after a black-out a single camera goes on") {
  test::Host host(oneCamera(), {{"camera_height", 1.5}}, direct_sparse::Cameras::Single);
  for (int k = 0; k < 20; ++k) {
    Frame frame = streetLeft(k, 0.25);
    if (k == 14) frame.left = test::filled(0);
    const Motion motion = host.track(frame);
    CHECK((motion.state == TrackingState::Lost) == (k == 14));
  }
}

TEST_CASE("an uncalibrated camera is refused") {
  CameraRig rig = oneCamera();
  rig.calibrated = false;
  const test::Host host(rig, {}, direct_sparse::Cameras::Single);
  CHECK(host.configured().code() == StatusCode::Unsupported);
}
