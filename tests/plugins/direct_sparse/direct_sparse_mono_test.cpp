// SPDX-License-Identifier: BSD-3-Clause
// One camera on the rendered street: the shape of the drive, without its scale.
#include <catch2/catch.hpp>

#include "harness.hpp"
#include "street.hpp"

using namespace tolman;

namespace {

Frame streetLeft(int k, double step) {
  Frame frame = test::streetFrame(k, test::streetPose(step * k, 0.004 * k));
  frame.right = Image();
  return frame;
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
