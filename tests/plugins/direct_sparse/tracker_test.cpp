// SPDX-License-Identifier: BSD-3-Clause
// Which motion is accepted, and when none is.
#include "tracker.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

struct TrackerCase {
  CameraRig rig = test::streetRig();
  std::unique_ptr<Window> window = test::streetWindow({test::streetPose(0)});
  Tracker tracker;

  TrackerCase() {
    test::addTruePoints(*window, 600);
    REQUIRE(tracker.setReference(rig, *window));
  }
};

double trackedOff(const AlignmentResult& result, const Eigen::Isometry3d& truth) {
  return (result.state.T_current_reference * truth).translation().norm();
}

}  // namespace

TEST_CASE("a fast start: without any velocity, large steps both ways are found") {
  for (const double step : {-1.6, -0.6, 0.0, 0.9, 1.9}) {
    TrackerCase c;
    const Eigen::Isometry3d pose = test::streetPose(step, 0.01);
    const auto result = c.tracker.track(c.rig, test::streetPyramid(pose), {});
    CAPTURE(step);
    REQUIRE(result);
    CHECK(trackedOff(*result, pose) < 0.01);
  }
}

TEST_CASE("a wrong expectation is overruled: stopping and turning back") {
  TrackerCase c;
  Expectation expectation;
  expectation.T_reference_previous = test::streetPose(0.5);
  expectation.T_previous_current = test::streetPose(0.8);
  expectation.has_velocity = true;
  for (const double z : {0.5, -0.3}) {  // stands still; drives back
    const Eigen::Isometry3d pose = test::streetPose(z);
    const auto result = c.tracker.track(c.rig, test::streetPyramid(pose), expectation);
    CAPTURE(z);
    REQUIRE(result);
    CHECK(trackedOff(*result, pose) < 0.01);
  }
}

TEST_CASE("another place is not recognised") {
  TrackerCase c;
  const Eigen::Isometry3d elsewhere = Eigen::Isometry3d(Eigen::Translation3d(2, 0, 31)) *
                                      Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitY());
  CHECK_FALSE(c.tracker.track(c.rig, test::streetPyramid(elsewhere), {}));
  Expectation expectation;
  expectation.has_velocity = true;
  CHECK_FALSE(c.tracker.track(c.rig, test::streetPyramid(elsewhere), expectation));
}

TEST_CASE("a reference without points cannot be tracked from") {
  const auto window = test::streetWindow({test::streetPose(0)});
  Tracker tracker;
  CHECK_FALSE(tracker.setReference(test::streetRig(), *window));
}

TEST_CASE("from the guess of features a part of the view is enough") {
  TrackerCase c;
  const Eigen::Isometry3d pose = test::streetPose(0.6, 0.01);
  const auto first = c.tracker.track(c.rig, test::streetPyramid(test::streetPose(0.3)), {});
  REQUIRE(first);  // says what is usual
  Frame frame = test::streetFrame(1, pose);
  auto* pixels = const_cast<std::uint8_t*>(frame.left.data());
  for (int v = 0; v < frame.left.height(); ++v) {  // a lorry
    std::fill_n(pixels + v * frame.left.stride(), frame.left.width() * 35 / 100, std::uint8_t{40});
  }
  ImagePyramid covered;
  covered.build(frame.left);
  const auto refined = c.tracker.refine(c.rig, covered, {pose.inverse(), {}});
  REQUIRE(refined);
  CHECK(trackedOff(*refined, pose) < 0.02);
  const AlignmentState elsewhere{test::streetPose(20, 0.5).inverse(), {}};
  CHECK_FALSE(c.tracker.refine(c.rig, covered, elsewhere));
}
