// SPDX-License-Identifier: BSD-3-Clause
// The plugin on a rendered street: known motions, lost images, reset, determinism, refusals.
#include "direct_sparse.hpp"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>

#include "harness.hpp"
#include "street.hpp"
#include "support/long_gap.hpp"

using namespace tolman;
using Catch::Matchers::Contains;
using test::again;

namespace {

/// Forward half a metre and half a degree to the left a frame.
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
    for (int k = 0; k < 14; ++k) made.push_back(test::streetFrame(k, curve(k)));
    return made;
  }();
  return frames;
}

const Frame& place(int k) { return streetFrames()[static_cast<std::size_t>(k)]; }

void checkClose(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double metres,
                double radians) {
  const Vector6d error = logSe3(a.inverse() * b);
  CHECK(error.head<3>().norm() < metres);
  CHECK(error.tail<3>().norm() < radians);
}

std::vector<Motion> run(test::Host& host, int frames) {
  std::vector<Motion> motions;
  for (int k = 0; k < frames; ++k) motions.push_back(host.track(place(k)));
  return motions;
}

/// What the right camera sees if it is turned such that what is ahead appears one pixel farther
/// right, by linear interpolation.
Image turnedRight(const Image& image) {
  const CameraRig rig = test::streetRig();
  return Image::create(
      image.width(), image.height(), PixelFormat::Gray8, [&image, &rig](std::uint8_t* data) {
        for (int v = 0; v < image.height(); ++v) {
          for (int u = 0; u < image.width(); ++u) {
            const double x = (u - rig.pinhole.cx) / rig.pinhole.fx;
            const double from = std::max(0.0, u - 1 - x * x);
            const int left = static_cast<int>(from);
            const double part = from - left;
            const double value = (1 - part) * image.row(v)[left] + part * image.row(v)[left + 1];
            *data++ = static_cast<std::uint8_t>(value + 0.5);
          }
        }
      });
}

void checkSame(const std::vector<Motion>& a, const std::vector<Motion>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    CHECK(a[k].T_previous_current.matrix() == b[k].T_previous_current.matrix());
    CHECK(a[k].covariance == b[k].covariance);
    CHECK(a[k].points == b[k].points);
    REQUIRE(a[k].revisions.size() == b[k].revisions.size());
    for (std::size_t r = 0; r < a[k].revisions.size(); ++r) {
      CHECK(a[k].revisions[r].T_previous_current.matrix() ==
            b[k].revisions[r].T_previous_current.matrix());
    }
  }
}

}  // namespace

TEST_CASE("standing while people walk past, the path is a matter of centimetres") {
  test::Host host(test::streetRig());
  for (int k = 0; k < 300; ++k) host.track(test::withPassersBy(place(3), k));
  CHECK(host.length() < 0.05);
  CHECK(host.trajectory().back().translation().norm() < 0.02);
}

TEST_CASE("a creeping camera is late at no place for long") {
  test::Host host(test::streetRig());
  constexpr double kStep = 0.0005;  // m
  for (int k = 0; k < 120; ++k) {
    const Eigen::Isometry3d pose(Eigen::Translation3d(0, 0, kStep * k));
    host.track(test::streetFrame(k, pose));
    CHECK(std::fabs(host.trajectory().back().translation().z() - kStep * k) < 0.015);
  }
}

TEST_CASE("a drive along a curve is measured; v is negative when reversing") {
  const bool backwards = GENERATE(false, true);
  test::Host host(test::streetRig());
  const int count = static_cast<int>(streetFrames().size());
  for (int k = 0; k < count; ++k) {
    const Motion motion = host.track(again(place(backwards ? count - 1 - k : k), k));
    CHECK(motion.frame == k);
    if (k == 0) {
      CHECK(motion.state == TrackingState::Initialising);
      CHECK(motion.is_keyframe);
      CHECK(motion.T_previous_current.matrix().isIdentity(0));
      continue;
    }
    CHECK(motion.state == TrackingState::Tracking);
    CHECK(motion.scale_known);
    CHECK(motion.tracked > 200);
    CHECK(motion.v == Approx(backwards ? -5 : 5).margin(0.15));
    CHECK(motion.omega == Approx(backwards ? -0.1 : 0.1).margin(0.01));
    const Eigen::LLT<Matrix6d> positive(motion.covariance);
    CHECK(positive.info() == Eigen::Success);
    CHECK(std::sqrt(motion.covariance(2, 2)) < 0.05);
  }
  host.finish();
  const Eigen::Isometry3d whole = backwards ? curve(count - 1).inverse() : curve(count - 1);
  checkClose(host.trajectory().back(), whole, 0.03, 0.002);  // of 6.5 m
}

TEST_CASE("without the static term the drive is still measured, its scale by the first depths") {
  test::Host host(test::streetRig(), {{"coupling", 0.0}});
  run(host, 10);
  host.finish();
  checkClose(host.trajectory().back(), curve(9), 0.15, 0.004);
}

TEST_CASE("motions are revised when the window moves its keyframes, each once by its frame") {
  test::Host host(test::streetRig());
  std::size_t revised = 0;
  for (int k = 0; k < 14; ++k) {
    for (const MotionRevision& revision : host.track(place(k)).revisions) {
      ++revised;
      CHECK(revision.frame < k);
      CHECK(revision.frame > 0);
      CHECK(revision.covariance.allFinite());
    }
  }
  CHECK(revised > 0);
}

TEST_CASE("points of a keyframe have the street's depth and a variance") {
  test::Host host(test::streetRig());
  const Motion motion = host.track(place(0));
  CHECK(motion.points_frame == 0);
  REQUIRE(motion.points.cols() > 200);
  int wrong = 0;
  for (Eigen::Index i = 0; i < motion.points.cols(); ++i) {
    const Eigen::Vector4d p = motion.points.col(i).cast<double>();
    const double truth = test::streetInverseDepth(curve(0), p[0], p[1]);
    CHECK(p[3] > 0);
    wrong += std::abs(p[2] - truth) * 150 > 0.5 ? 1 : 0;  // px of disparity
  }
  CHECK(20 * wrong < motion.points.cols());
}

TEST_CASE("standing still stays put and makes no keyframes") {
  test::Host host(test::streetRig());
  for (int k = 0; k < 8; ++k) {
    const Motion motion = host.track(again(place(3), k));
    if (k == 0) continue;
    CHECK(motion.state == TrackingState::Tracking);
    CHECK(motion.T_previous_current.translation().norm() < 1e-3);
    CHECK_FALSE(motion.is_keyframe);
  }
  CHECK(host.length() < 2e-3);
}

TEST_CASE("turning round on the spot of a road is no loss") {
  test::Host host(test::streetRig());
  const int places[] = {0, 1, 2, 3, 4, 3, 2, 1, 0};
  for (int k = 0; k < 9; ++k) {
    CHECK(host.track(again(place(places[k]), k)).state != TrackingState::Lost);
  }
  host.finish();
  CHECK(host.trajectory().back().translation().norm() < 0.03);
}

TEST_CASE("images that show nothing: lost, predicted, and measured across the gap afterwards") {
  const std::string kind = GENERATE("missing", "black", "grey", "white");
  CAPTURE(kind);
  test::Host host(test::streetRig());
  double sigma = 0;
  for (int k = 0; k < 12; ++k) {
    Frame frame = place(k);
    const bool blind = k == 5 || k == 6;
    if (blind && kind == "missing") {
      frame.left = frame.right = Image();
      frame.defect = "left/000005.png is damaged";
    }
    if (blind && kind == "black") frame.left = frame.right = test::filled(0);
    if (blind && kind == "grey") frame.left = frame.right = test::filled(128);
    if (blind && kind == "white") frame.left = frame.right = test::filled(255);
    const Motion motion = host.track(frame);
    if (k > 0) CHECK((motion.state == TrackingState::Lost) == blind);
    if (!blind) continue;
    CHECK(motion.T_previous_current.translation().z() == Approx(0.5).margin(0.05));
    CHECK(motion.covariance(2, 2) > sigma);
    sigma = motion.covariance(2, 2);
  }
  host.finish();
  checkClose(host.trajectory().back(), curve(11), 0.05, 0.003);
  CHECK_THAT(host.log().front(), Contains("tracking lost"));
}

TEST_CASE("a covered right camera: tracking goes on with the left one") {
  test::Host host(test::streetRig());
  for (int k = 0; k < 14; ++k) {
    Frame frame = place(k);
    if (k >= 4 && k < 8) frame.right = test::filled(3);
    const Motion motion = host.track(frame);
    if (k > 0) CHECK(motion.state == TrackingState::Tracking);
  }
  host.finish();
  checkClose(host.trajectory().back(), curve(13), 0.06, 0.004);
}

TEST_CASE("swapped cameras for some frames have a defined state and are survived") {
  test::Host host(test::streetRig());
  for (int k = 0; k < 14; ++k) {
    Frame frame = place(k);
    if (k == 5 || k == 6) std::swap(frame.left, frame.right);
    const Motion motion = host.track(frame);
    // A left image half a metre to the right is a motion sideways, or nothing recognised.
    CHECK((k == 0 || motion.state != TrackingState::Initialising));
    if (k > 8) CHECK(motion.state == TrackingState::Tracking);
    if (k > 8) checkClose(motion.T_previous_current, curve(1), 0.05, 0.01);
  }
}

TEST_CASE("a right camera that is turned by one pixel is noticed, and the length stays true") {
  const auto driven = [](tolman::ParameterValues values) {
    test::Host host(test::streetRig(), std::move(values));
    for (int k = 0; k < 14; ++k) {
      Frame frame = place(k);
      frame.right = turnedRight(frame.right);
      CHECK(host.track(frame).state != TrackingState::Lost);
    }
    host.finish();
    return std::pair(host.plugin().disparityOffset(), host.trajectory().back());
  };
  const double true_length = curve(13).translation().norm();
  const auto [offset, end] = driven({});
  CHECK(offset == Approx(1 + 0.21).margin(0.2));  // the mean of 1 + x^2 over the image
  CHECK(end.translation().norm() == Approx(true_length).epsilon(0.01));
  const auto [none, far_end] = driven({{"offset_sigma", 0.0}});
  CHECK(none == Approx(0).margin(1e-3));
  CHECK(far_end.translation().norm() > 1.02 * true_length);
}

TEST_CASE("a sudden brightness step of 30 % is followed") {
  const double gain = GENERATE(0.7, 1.3);
  test::Host host(test::streetRig());
  for (int k = 0; k < 12; ++k) {
    Frame frame = place(k);
    if (k >= 5) {
      frame.left = test::changed(frame.left, gain, 0);
      frame.right = test::changed(frame.right, gain, 0);
    }
    const Motion motion = host.track(frame);
    if (k > 0) CHECK(motion.state == TrackingState::Tracking);
  }
  host.finish();
  checkClose(host.trajectory().back(), curve(11), 0.05, 0.003);
}

TEST_CASE("over an hour without images the camera is not taken to have driven on") {
  test::Host host(test::streetRig());
  const Motion motion = test::afterAnHour(host, streetFrames());
  REQUIRE(motion.state == TrackingState::Lost);
  CHECK(motion.T_previous_current.translation().norm() < 5.2 * 5);  // 5 m/s for 5 s
  CHECK(motion.covariance(2, 2) > 1e4);                             // and what is not known
}

TEST_CASE("when nothing is left to recognise, a new start goes on from the prediction") {
  test::Host host(test::streetRig());
  const Eigen::Isometry3d elsewhere = Eigen::Isometry3d(Eigen::Translation3d(2, 0, 31)) *
                                      Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitY());
  const Eigen::Isometry3d step(Eigen::Translation3d(0, 0, 0.3));
  for (int k = 0; k < 4; ++k) host.track(place(k));
  Eigen::Isometry3d pose = elsewhere;
  int lost = 0;
  for (int k = 4; k < 9; ++k, pose = pose * step) {
    const Motion motion = host.track(test::streetFrame(k, pose));
    if (motion.state == TrackingState::Lost) {
      ++lost;
      CHECK(motion.T_previous_current.translation().norm() < 1);  // no leap
      CHECK(motion.covariance(0, 0) > 0.01);
      CHECK(motion.is_keyframe == (lost == 2));  // patience of one frame, then a new window
    } else {
      checkClose(motion.T_previous_current, step, 0.02, 0.003);
    }
  }
  CHECK(lost == 2);
}

TEST_CASE("a blind start waits for the first good pair; a covered one for depth") {
  test::Host host(test::streetRig());
  Frame blind = place(0);
  blind.left = blind.right = test::filled(0);
  CHECK(host.track(blind).state == TrackingState::Initialising);
  const Motion first = host.track(place(1));
  CHECK(first.state == TrackingState::Initialising);
  CHECK(first.is_keyframe);
  CHECK(first.covariance(0, 0) > 1);
  CHECK(host.track(place(2)).state == TrackingState::Tracking);

  test::Host covered(test::streetRig());
  for (int k = 0; k < 8; ++k) {
    Frame frame = place(k);
    if (k < 3) frame.right = test::filled(0);
    const Motion motion = covered.track(frame);
    if (k > 5) CHECK(motion.state == TrackingState::Tracking);
    if (k > 0 && k < 3) CHECK(motion.state != TrackingState::Tracking);
  }
}

TEST_CASE("reset equals fresh, and any number of threads gives the same bytes") {
  test::Host host(test::streetRig());
  const auto first = run(host, 7);
  REQUIRE(host.plugin().reset().isOk());
  checkSame(run(host, 7), first);
  for (const std::size_t threads : {1U, 2U, 4U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    test::Host other(test::streetRig());
    checkSame(run(other, 7), first);
  }
}

TEST_CASE("odd image widths track like even ones") {
  CameraRig rig = test::streetRig();
  rig.width -= 1;
  rig.height -= 1;
  test::Host host(rig);
  for (int k = 0; k < 8; ++k) {
    Frame frame = place(k);
    for (Image* image : {&frame.left, &frame.right}) {
      *image = Image(image->data(), rig.width, rig.height, image->stride(), image->format(),
                     image->owner());
    }
    CHECK(host.track(frame).state != TrackingState::Lost);
  }
  host.finish();
  checkClose(host.trajectory().back(), curve(7), 0.03, 0.002);
}

TEST_CASE("cameras that are no stereo pair are refused, with the remedy") {
  CameraRig rig = test::streetRig();
  Frame frame = place(0);
  Motion motion;
  SECTION("one camera") {
    rig.baseline = 0;
    const Status status = test::Host(rig).configured();
    CHECK(status.code() == StatusCode::Unsupported);
    CHECK(status.message() ==
          "the cameras are not a stereo pair; use an odometry plugin for such cameras, or a source "
          "of calibrated, rectified stereo images");
  }
  SECTION("not calibrated") {
    rig.calibrated = false;
    const Status status = test::Host(rig).configured();
    CHECK(status.code() == StatusCode::Unsupported);
    CHECK_THAT(status.message(), Contains("the cameras are not calibrated"));
  }
  SECTION("too small") {
    rig.height = 40;
    CHECK_THAT(test::Host(rig).configured().message(),
               Contains("images of 480x40 pixels are too small"));
  }
  SECTION("no right image") {
    frame.right = Image();
    test::Host host(rig);
    const Status status = host.plugin().track(frame, motion);
    CHECK(status.code() == StatusCode::Unsupported);
    CHECK_THAT(status.message(), Contains("no right image; use a monocular odometry plugin"));
  }
  SECTION("another size") {
    rig.width = 640;
    test::Host host(rig);
    const Status status = host.plugin().track(frame, motion);
    CHECK(status.code() == StatusCode::InvalidInput);
    CHECK_THAT(status.message(), Contains("480x200 pixels, its calibration 640x200"));
  }
}
