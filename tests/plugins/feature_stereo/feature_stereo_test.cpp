// SPDX-License-Identifier: BSD-3-Clause
// The plugin on a rendered street: known motions, lost images, reset, determinism, refusals.
#include "feature_stereo.hpp"

#include <catch2/catch.hpp>
#include <opencv2/imgproc.hpp>

#include "support/long_gap.hpp"
#include "support/odometry_host.hpp"
#include "support/street_scene.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;
using Catch::Matchers::Contains;
using test::again;
using test::filled;

namespace {

using Host = test::OdometryHost<feature_stereo::FeatureStereo>;

/// Forward half a metre and a degree to the left a frame.
Eigen::Isometry3d curve(int k) {
  Eigen::Isometry3d step = Eigen::Isometry3d(Eigen::Translation3d(0, 0, 0.5));
  step.rotate(Eigen::AngleAxisd(-0.01, Eigen::Vector3d::UnitY()));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < k; ++i) pose = pose * step;
  return pose;
}

const std::vector<Frame>& streetFrames() {
  static const std::vector<Frame> frames = [] {
    std::vector<Frame> made;
    for (int k = 0; k < 12; ++k) made.push_back(test::streetFrame(k, curve(k)));
    return made;
  }();
  return frames;
}

void checkClose(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double metres,
                double radians) {
  const Vector6d error = logSe3(a.inverse() * b);
  CHECK(error.head<3>().norm() < metres);
  CHECK(error.tail<3>().norm() < radians);
}

}  // namespace

TEST_CASE("a drive along a curve is measured, forwards and backwards") {
  const bool backwards = GENERATE(false, true);
  Host host(test::streetRig());
  const auto& frames = streetFrames();
  const int count = static_cast<int>(frames.size());
  for (int k = 0; k < count; ++k) {
    const int place = backwards ? count - 1 - k : k;
    const Motion motion = host.track(again(frames[static_cast<std::size_t>(place)], k));
    CHECK(motion.frame == k);
    CHECK(firstInvalidField(motion).empty());
    if (k == 0) {
      CHECK(motion.state == TrackingState::Initialising);
      CHECK(motion.is_keyframe);
      CHECK(motion.T_previous_current.matrix().isIdentity(0));
      continue;
    }
    CHECK(motion.state == TrackingState::Tracking);
    CHECK(motion.tracked > 50);
    CHECK(motion.v == Approx(backwards ? -5 : 5).margin(0.3));
    CHECK(motion.omega == Approx(backwards ? -0.1 : 0.1).margin(0.02));
    const Eigen::LLT<Matrix6d> positive(motion.covariance);
    CHECK(positive.info() == Eigen::Success);
    CHECK(std::sqrt(motion.covariance(2, 2)) < 0.05);
  }
  host.finish();
  const Eigen::Isometry3d whole = backwards ? curve(count - 1).inverse() : curve(count - 1);
  checkClose(host.trajectory().back(), whole, 0.06, 0.003);  // of 5.5 m
}

TEST_CASE("points of a keyframe have the street's depth") {
  Host host(test::streetRig());
  const Motion motion = host.track(streetFrames()[0]);
  REQUIRE(motion.is_keyframe);
  CHECK(motion.points_frame == 0);
  REQUIRE(motion.points.cols() > 100);
  int on_ground = 0;
  int wrong = 0;
  for (Eigen::Index i = 0; i < motion.points.cols(); ++i) {
    const Eigen::Vector4d p = motion.points.col(i).cast<double>();
    CHECK(p[3] > 0);
    const Eigen::Vector3d ray = test::streetRig().pinhole.ray(p.head<2>());
    const double height = ray.y() / p[2];
    if (std::abs(ray.x() / p[2]) > 3.5 || height < 0.5) continue;
    ++on_ground;
    wrong += std::abs(height - 1.5) > 0.25 ? 1 : 0;
  }
  CHECK(on_ground > 20);
  CHECK(10 * wrong <= on_ground);  // one view alone cannot find every wrong match
}

TEST_CASE("a camera at rest has no motion") {
  Host host(test::streetRig());
  for (int k = 0; k < 8; ++k) {
    const Motion motion = host.track(again(streetFrames()[3], k));
    if (k == 0) continue;
    CHECK(motion.state == TrackingState::Tracking);
    CHECK(motion.T_previous_current.translation().norm() < 1e-3);
    CHECK_FALSE(motion.is_keyframe);
  }
  CHECK(host.length() < 2e-3);
}

TEST_CASE("standing while people walk past, the path is a matter of centimetres") {
  Host host(test::streetRig());
  for (int k = 0; k < 300; ++k) host.track(test::withPassersBy(streetFrames()[3], k));
  CHECK(host.length() < 0.05);
  CHECK(host.trajectory().back().translation().norm() < 0.02);
}

TEST_CASE("a creeping camera is late at no place for long") {
  Host host(test::streetRig());
  constexpr double kStep = 0.0005;  // m
  for (int k = 0; k < 120; ++k) {
    const Eigen::Isometry3d pose(Eigen::Translation3d(0, 0, kStep * k));
    host.track(test::streetFrame(k, pose));
    CHECK(std::fabs(host.trajectory().back().translation().z() - kStep * k) < 0.015);
  }
}

TEST_CASE("turning round on the spot of a road is no loss") {
  Host host(test::streetRig());
  const int places[] = {0, 1, 2, 3, 4, 3, 2, 1, 0};
  for (int k = 0; k < 9; ++k) {
    const auto place = static_cast<std::size_t>(places[k]);
    const Motion motion = host.track(again(streetFrames()[place], k));
    CHECK(motion.state != TrackingState::Lost);
  }
  host.finish();
  CHECK(host.trajectory().back().translation().norm() < 0.05);
}

TEST_CASE("images that show nothing: lost, predicted, and measured across the gap afterwards") {
  const std::string kind = GENERATE("missing", "black", "white", "right covered");
  CAPTURE(kind);
  Host host(test::streetRig());
  double sigma = 0;
  for (int k = 0; k < 12; ++k) {
    Frame frame = streetFrames()[static_cast<std::size_t>(k)];
    const bool blind = k == 5 || k == 6;
    if (blind && kind == "missing") {
      frame.left = frame.right = Image();
      frame.defect = "left/000005.png is damaged";
    }
    if (blind && kind == "black") frame.left = frame.right = filled(0);
    if (blind && kind == "white") frame.left = frame.right = filled(255);
    if (blind && kind == "right covered") frame.right = filled(3);
    const Motion motion = host.track(frame);
    if (k > 0) CHECK((motion.state == TrackingState::Lost) == blind);
    if (!blind) continue;
    CHECK(motion.T_previous_current.translation().z() == Approx(0.5).margin(0.05));
    CHECK(motion.covariance(2, 2) > sigma);
    sigma = motion.covariance(2, 2);
  }
  host.finish();
  checkClose(host.trajectory().back(), curve(11), 0.08, 0.004);
}

TEST_CASE("over an hour without images the camera is not taken to have driven on") {
  Host host(test::streetRig());
  const Motion motion = test::afterAnHour(host, streetFrames());
  REQUIRE(motion.state == TrackingState::Lost);
  CHECK(motion.T_previous_current.translation().norm() < 5.2 * 5);  // 5 m/s for 5 s
  CHECK(motion.covariance(2, 2) > 1e4);                             // and what is not known
}

TEST_CASE("when nothing is left to recognise, a new start goes on from the prediction") {
  Host host(test::streetRig());
  const Eigen::Isometry3d elsewhere = Eigen::Isometry3d(Eigen::Translation3d(2, 0, 31)) *
                                      Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitY());
  for (int k = 0; k < 4; ++k) host.track(streetFrames()[static_cast<std::size_t>(k)]);
  const Motion jump = host.track(test::streetFrame(4, elsewhere));
  CHECK(jump.state == TrackingState::Lost);
  CHECK(jump.is_keyframe);
  CHECK(jump.T_previous_current.translation().norm() < 1);  // no leap
  CHECK(jump.covariance(0, 0) > 0.01);
  const Eigen::Isometry3d step(Eigen::Translation3d(0, 0, 0.4));
  const Motion next = host.track(test::streetFrame(5, elsewhere * step));
  CHECK(next.state == TrackingState::Tracking);
  checkClose(next.T_previous_current, step, 0.03, 0.003);
}

TEST_CASE("odometry starts at the first pair with contrast") {
  Host host(test::streetRig());
  Frame blind = streetFrames()[0];
  blind.left = blind.right = filled(0);
  CHECK(host.track(blind).state == TrackingState::Initialising);
  const Motion first = host.track(streetFrames()[1]);
  CHECK(first.state == TrackingState::Initialising);
  CHECK(first.covariance(0, 0) > 1);
  CHECK(host.track(streetFrames()[2]).state == TrackingState::Tracking);
}

TEST_CASE("reset equals fresh, and two runs agree bit by bit") {
  const auto run = [](Host& host) {
    std::vector<Motion> motions;
    for (std::size_t k = 0; k < 6; ++k) motions.push_back(host.track(streetFrames()[k]));
    return motions;
  };
  Host host(test::streetRig());
  Host other(test::streetRig());
  const auto first = run(host);
  const auto second = run(other);
  REQUIRE(host.plugin().reset().isOk());
  const auto third = run(host);
  for (std::size_t k = 0; k < first.size(); ++k) {
    for (const Motion* motion : {&second[k], &third[k]}) {
      CHECK(first[k].T_previous_current.matrix() == motion->T_previous_current.matrix());
      CHECK(first[k].covariance == motion->covariance);
      CHECK(first[k].points == motion->points);
      REQUIRE(first[k].revisions.size() == motion->revisions.size());
      for (std::size_t r = 0; r < motion->revisions.size(); ++r) {
        CHECK(first[k].revisions[r].T_previous_current.matrix() ==
              motion->revisions[r].T_previous_current.matrix());
      }
    }
  }
}

TEST_CASE("colour images are measured like grey ones") {
  Host grey(test::streetRig());
  Host colour(test::streetRig());
  for (std::size_t k = 0; k < 3; ++k) {
    Frame frame = streetFrames()[k];
    const Motion expected = grey.track(frame);
    for (Image* image : {&frame.left, &frame.right}) {
      cv::Mat bgr;
      cv::cvtColor(asMat(*image), bgr, cv::COLOR_GRAY2BGR);
      *image = asImage(bgr);
    }
    checkClose(colour.track(frame).T_previous_current, expected.T_previous_current, 1e-9, 1e-9);
  }
}

TEST_CASE("cameras that are no stereo pair are refused, with the remedy") {
  CameraRig rig = test::streetRig();
  Frame frame = streetFrames()[0];
  Motion motion;
  SECTION("one camera") {
    rig.baseline = 0;
    const Status status = Host(rig).configured();
    CHECK(status.code() == StatusCode::Unsupported);
    CHECK(status.message() ==
          "the cameras are not a stereo pair; use an odometry plugin for such cameras, or a source "
          "of calibrated, rectified stereo images");
  }
  SECTION("not calibrated") {
    rig.calibrated = false;
    const Status status = Host(rig).configured();
    CHECK(status.code() == StatusCode::Unsupported);
    CHECK_THAT(status.message(), Contains("the cameras are not calibrated"));
  }
  SECTION("no right image") {
    frame.right = Image();
    Host host(rig);
    const Status status = host.plugin().track(frame, motion);
    CHECK(status.code() == StatusCode::Unsupported);
    CHECK_THAT(status.message(), Contains("no right image; use a monocular odometry plugin"));
  }
  SECTION("another size") {
    rig.width = 640;
    Host host(rig);
    const Status status = host.plugin().track(frame, motion);
    CHECK(status.code() == StatusCode::InvalidInput);
    CHECK_THAT(status.message(), Contains("480x200 pixels, its calibration 640x200"));
  }
}
