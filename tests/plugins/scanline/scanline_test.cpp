// SPDX-License-Identifier: BSD-3-Clause
// The plugin as the host calls it: turns, distances, failures, defects of the published program.
#include "scanline.hpp"

#include <catch2/catch.hpp>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::scanline;
using namespace tolman::scanline::test;

namespace {

double turnOf(const Motion& motion) { return toPlanar(motion.T_previous_current).theta; }
double wayOf(const Motion& motion) { return motion.T_previous_current.translation().norm(); }

/// A road surface that streams by: its profile changes with the way, and comes back never.
Image road(double metres) {
  return gray(320, 120, [&](int x, int) {
    const double left = x < 160 ? -1 : 1;
    return std::lround(128 + 60 * std::sin(0.11 * x - 3 * left * metres + 0.002 * x * x));
  });
}

}  // namespace

TEST_CASE("a turn before a panorama is measured, left positive, pinhole or not") {
  const CameraRig rig = GENERATE(pinholeRig(), unknownRig());
  const double degrees = GENERATE(-8.0, -0.5, 0.3, 3.0, 11.0);
  const double turn = degrees / 57.29577951;
  Host host(rig, whole({{"field_of_view", 57.29577951}}));
  REQUIRE(host.configured().isOk());
  host.see(view(rig, 1.0));
  const Motion motion = host.see(view(rig, 1.0 + turn));
  CHECK(motion.state == TrackingState::Tracking);
  CHECK(turnOf(motion) == Approx(turn).margin(0.0015));
  CHECK(motion.omega == Approx(turn / 0.1).margin(0.015));
  CHECK_FALSE(motion.scale_known);
}

TEST_CASE("at the first frame there is nothing to compare with: no speed") {
  Host host(unknownRig());
  const Motion first = host.see(road(0));
  CHECK(first.state == TrackingState::Initialising);
  CHECK(first.T_previous_current.isApprox(Eigen::Isometry3d::Identity()));
  CHECK(first.v == 0);
  CHECK(first.omega == 0);
  // Nor is the second measured against an empty profile.
  CHECK(host.see(road(0)).v == 0);
}

TEST_CASE("the way grows with the change of the picture, whatever the frame rate") {
  Host host(unknownRig(), {{"metres_per_difference", 10.0}});
  host.see(road(0));
  const Motion slow = host.see(road(0.01));
  const Motion fast = host.see(road(0.03));
  CHECK(wayOf(slow) > 0.02);
  CHECK(wayOf(fast) > 1.5 * wayOf(slow));
  CHECK(fast.v == Approx(wayOf(fast) / 0.1));

  Host lazy(unknownRig(), {{"metres_per_difference", 10.0}});
  lazy.see(road(0));
  const Motion half_rate = lazy.see(road(0.01), 2 * kStep);
  CHECK(wayOf(half_rate) == Approx(wayOf(slow)));
  CHECK(half_rate.v == Approx(0.5 * slow.v));
}

TEST_CASE("the scale is one number; noise stands still; the fastest is cut off") {
  const auto way = [](double scale, double still, double fastest) {
    Host host(unknownRig(),
              {{"metres_per_difference", scale}, {"still", still}, {"largest_speed", fastest}});
    host.see(road(0));
    return wayOf(host.see(road(0.02)));
  };
  CHECK(way(20, 0, 1e4) == Approx(2 * way(10, 0, 1e4)));
  CHECK(way(20, 0.5, 1e4) == 0);
  CHECK(way(1000, 0, 5) == Approx(0.5));
}

TEST_CASE("a change of exposure is neither way nor turn") {
  const CameraRig rig = pinholeRig();
  Host host(rig, whole());
  host.see(gray(320, 120, [](int x, int) { return 100 + 40 * std::sin(0.1 * x + 1e-3 * x * x); }));
  const Motion motion = host.see(
      gray(320, 120, [](int x, int) { return 130 + 40 * std::sin(0.1 * x + 1e-3 * x * x); }));
  CHECK(wayOf(motion) < 0.05);
  CHECK(std::abs(turnOf(motion)) < 0.002);
}

TEST_CASE("where profiles cannot tell the turn, the covariance says so") {
  const CameraRig rig = unknownRig();
  Host sharp(rig, whole());
  sharp.see(view(rig, 0));
  const double sure = sharp.see(view(rig, 0.02)).covariance(4, 4);
  Host fence(rig, whole());
  const auto pickets = [](int x, int) { return x % 20 < 3 ? 200 : 50; };
  fence.see(gray(320, 120, pickets));
  CHECK(fence.see(gray(320, 120, pickets)).covariance(4, 4) > 20 * sure);
  CHECK(std::sqrt(sure) >= 0.3 / 57.3);
}

TEST_CASE("covariances are symmetric and positive; unseen directions are not claimed to be exact") {
  Host host(unknownRig());
  host.see(road(0));
  const Matrix6d covariance = host.see(road(0.02)).covariance;
  CHECK(covariance.isApprox(covariance.transpose()));
  CHECK(covariance.diagonal().minCoeff() > 0);
}

TEST_CASE("without an image: lost, going on as before, and caught up with afterwards") {
  const CameraRig rig = pinholeRig();
  Host host(rig, whole());
  host.see(view(rig, 0));
  host.see(view(rig, 0.02));
  const Motion lost = host.see(Image());
  CHECK(lost.state == TrackingState::Lost);
  CHECK(turnOf(lost) == Approx(0.02).margin(0.002));
  const Motion longer = host.see(gray(320, 120, [](int, int) { return 3; }));  // a dark one
  CHECK(longer.state == TrackingState::Lost);
  CHECK(longer.covariance(4, 4) > lost.covariance(4, 4));
  // It stood still meanwhile: 0.04 were promised too many.
  const Motion back = host.see(view(rig, 0.02));
  CHECK(back.state == TrackingState::Tracking);
  CHECK(turnOf(lost) + turnOf(longer) + turnOf(back) == Approx(0).margin(0.002));
}

TEST_CASE("stamps and time steps are the data's") {
  Host host(unknownRig());
  CHECK(host.see(road(0), 70).stamp_ns == 5'000'000'070);
  const Motion motion = host.see(road(0.01), 250'000'000);
  CHECK(motion.stamp_ns == 5'250'000'070);
  CHECK(motion.dt == Approx(0.25));
  CHECK(motion.frame == 1);
}

TEST_CASE("reset: the same frames, the same bits") {
  const CameraRig rig = pinholeRig();
  Host host(rig, whole());
  host.see(view(rig, 0));
  const Motion once = host.see(view(rig, 0.03));
  REQUIRE(host.plugin.reset().isOk());
  CHECK(host.see(view(rig, 0)).state == TrackingState::Initialising);
  const Motion again = host.see(view(rig, 0.03));
  CHECK(again.T_previous_current.matrix() == once.T_previous_current.matrix());
  CHECK(again.covariance == once.covariance);
  std::vector<MotionRevision> revisions;
  CHECK(host.plugin.finish(revisions).isOk());
  CHECK(revisions.empty());
}

TEST_CASE("what cannot work is refused with the remedy") {
  const auto refusal = [](const CameraRig& rig, const ParameterValues& values) {
    return Host(rig, values).configured().message();
  };
  CHECK(
      refusal(unknownRig(), {{"turn_region", std::vector{0.8, 0.7, 0.2, 0.5}}}) ==
      "turn_region is empty: give [left, right, upper, lower] with left < right and upper < lower");
  CHECK(refusal(unknownRig(), {{"speed_region", std::vector{0.0, 1.0, 0.5}}})
            .rfind("speed_region is empty", 0) == 0);
  CHECK(refusal({}, {}) == "the source has no images; use a source with a camera");
  CHECK(refusal(unknownRig(16, 16), {}) ==
        "a part of the image has fewer than 8 columns; make it wider");
  Host host(unknownRig());
  CHECK_THROWS_WITH(host.see(gray(10, 10, [](int, int) { return 0; })),
                    "the image has 10x10 pixels, the camera 320x120; give images of one size");
}
