// SPDX-License-Identifier: BSD-3-Clause
// Odometry of one camera with depth images, on a rendered street with exact depths.
#include <catch2/catch.hpp>

#include "feature_stereo.hpp"
#include "support/odometry_host.hpp"
#include "support/street_scene.hpp"

using namespace tolman;

namespace {

using RgbdHost = test::OdometryHost<feature_stereo::FeatureRgbd>;

CameraRig oneCamera() {
  CameraRig rig = test::streetRig();
  rig.baseline = 0;
  return rig;
}

/// Forward 0.4 m and half a degree to the right a frame.
Eigen::Isometry3d bend(int k) {
  Eigen::Isometry3d step = Eigen::Isometry3d(Eigen::Translation3d(0, 0, 0.4));
  step.rotate(Eigen::AngleAxisd(0.0087, Eigen::Vector3d::UnitY()));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < k; ++i) pose = pose * step;
  return pose;
}

const std::vector<Frame>& depthFrames() {
  static const std::vector<Frame> frames = [] {
    std::vector<Frame> made;
    for (int k = 0; k < 10; ++k) {
      Frame& frame = made.emplace_back(test::streetFrame(k, bend(k)));
      frame.right = Image();
      frame.sensors = {test::streetDepth(bend(k))};
    }
    return made;
  }();
  return frames;
}

Eigen::Isometry3d lastPoseOf(RgbdHost& host, const std::vector<Frame>& frames) {
  for (const Frame& frame : frames) host.track(frame);
  host.finish();
  return host.trajectory().back();
}

double errorOf(const Eigen::Isometry3d& T_world_camera) {
  return (T_world_camera.translation() - bend(9).translation()).norm();
}

}  // namespace

TEST_CASE("one camera with depth images measures metres from the second frame on") {
  RgbdHost host(oneCamera());
  for (const Frame& frame : depthFrames()) {
    const Motion motion = host.track(frame);
    CHECK(motion.scale_known);
    if (frame.frame == 0) {
      CHECK(motion.state == TrackingState::Initialising);
      continue;
    }
    CHECK(motion.state == TrackingState::Tracking);
    CHECK(motion.v == Approx(4).margin(0.1));
  }
  host.finish();
  CHECK(errorOf(host.trajectory().back()) < 0.02);  // of 3.6 m
}

TEST_CASE("depths in millimetres instead of metres make the path a thousand times as long") {
  std::vector<Frame> frames = depthFrames();
  for (Frame& frame : frames) {
    for (float& depth : frame.sensors[0].values) depth *= 1000;
  }
  RgbdHost host(oneCamera(), {{"depth_noise", 1.5e-6}});
  const Eigen::Vector3d end = lastPoseOf(host, frames).translation();
  CHECK(end.norm() == Approx(1000 * bend(9).translation().norm()).epsilon(0.02));
}

TEST_CASE("frames in which no depth was measured are tracked with the landmarks that there are") {
  std::vector<Frame> frames = depthFrames();
  for (const std::size_t k : {4, 5}) {
    frames[k].sensors[0].values.assign(frames[k].sensors[0].values.size(), 0);
  }
  RgbdHost host(oneCamera());
  for (const Frame& frame : frames) {
    const Motion motion = host.track(frame);
    if (frame.frame > 0) CHECK(motion.state == TrackingState::Tracking);
  }
  host.finish();
  CHECK(errorOf(host.trajectory().back()) < 0.05);
}

TEST_CASE("without any depth there is no motion, and none is invented") {
  std::vector<Frame> frames = depthFrames();
  RgbdHost host(oneCamera());
  for (Frame& frame : frames) {
    frame.sensors[0].values.assign(frame.sensors[0].values.size(), 0);
    const Motion motion = host.track(frame);
    CHECK(motion.state == TrackingState::Initialising);
    CHECK(motion.T_previous_current.matrix().isIdentity(0));
  }
}

TEST_CASE("more noise of the depths means a larger covariance") {
  const auto variance = [](double noise) {
    RgbdHost host(oneCamera(), {{"depth_noise", noise}});
    host.track(depthFrames()[0]);
    return host.track(depthFrames()[1]).covariance(2, 2);
  };
  CHECK(variance(0.02) > 4 * variance(0.0015));
}

TEST_CASE("a right image changes nothing") {
  RgbdHost one(oneCamera());
  RgbdHost pair(test::streetRig());
  for (std::size_t k = 0; k < 3; ++k) {
    Frame frame = depthFrames()[k];
    const Motion expected = one.track(frame);
    frame.right = test::filled(7);
    CHECK(pair.track(frame).T_previous_current.matrix() == expected.T_previous_current.matrix());
  }
}

TEST_CASE("a depth sensor that repeats its image is told once, and its images are not used") {
  RgbdHost host(oneCamera());
  for (Frame frame : depthFrames()) {
    if (frame.frame > 4) frame.sensors = depthFrames()[4].sensors;
    host.track(frame);
  }
  host.finish();
  CHECK(errorOf(host.trajectory().back()) < 0.05);
  REQUIRE(host.log().size() == 1);
  CHECK_THAT(host.log()[0], Catch::Contains("the depth image repeats that of the frame before"));
}

TEST_CASE("at rest an image may come twice") {
  RgbdHost host(oneCamera());
  for (int k = 0; k < 5; ++k) {
    const Motion motion = host.track(test::again(depthFrames()[2], k));
    if (k > 0) CHECK(motion.state == TrackingState::Tracking);
  }
  CHECK(host.length() < 2e-3);
  CHECK(host.log().empty());
}

TEST_CASE("depth images of one value are told, and give no motion") {
  RgbdHost host(oneCamera());
  for (Frame frame : depthFrames()) {
    frame.sensors[0].values.assign(frame.sensors[0].values.size(), 10);
    CHECK(host.track(frame).state == TrackingState::Initialising);
  }
  REQUIRE(host.log().size() == 1);
  CHECK_THAT(host.log()[0], Catch::Contains("the depth image has one value everywhere"));
}
