// SPDX-License-Identifier: BSD-3-Clause
// Real images, if available: the error against the truth, and the lengths of paths.
#include <catch2/catch.hpp>

#include "harness.hpp"
#include "support/data.hpp"
#include "support/kitti_clip.hpp"

using namespace tolman;
using test::indexRange;
using test::KittiClip;

namespace {

/// The rig taken as exact, fewer keyframes with more points: what these bars were set for.
const ParameterValues kExactRig = {{"offset_sigma", 0.0},
                                   {"keyframe_weight", 0.4},
                                   {"points", std::int64_t{2000}},
                                   {"iterations", std::int64_t{4}},
                                   {"row_sigma", 0.0}};

double errorOf(const char* name, int first, int end) {
  const auto folder = test::dataOrSkip(std::string("kitti_clips/") + name);
  if (!folder) return 0;
  const KittiClip clip(*folder);
  test::Host host(clip.rig());
  CHECK(clip.run(host, indexRange(first, end)) == 0);
  const double metres = clip.ateRmse(host.trajectory(), indexRange(first, end));
  WARN(name << " from " << first << ": ATE " << metres << " m, offset "
            << host.plugin().disparityOffset() << " px");
  return metres;
}

}  // namespace

TEST_CASE("the default on KITTI 06, and on 01, whose disparities are a pixel too small", "[data]") {
  CHECK(errorOf("06", 0, 51) < 0.06);
  CHECK(errorOf("06", 50, -1) < 0.06);
  CHECK(errorOf("01", 0, 51) < 0.1);
  CHECK(errorOf("01", 50, -1) < 0.06);
}

TEST_CASE("KITTI 06, forwards, backwards and back again", "[data]") {
  const auto folder = test::dataOrSkip("kitti_clips/06");
  if (!folder) return;
  const KittiClip clip(*folder);
  test::Host host(clip.rig(), kExactRig);
  SECTION("forwards") {
    CHECK(clip.run(host, indexRange(0, 51)) == 0);
    CHECK(clip.ateRmse(host.trajectory(), indexRange(0, 51)) < 0.06);
  }
  SECTION("backwards") {
    CHECK(clip.run(host, indexRange(50, -1)) == 0);
    CHECK(clip.ateRmse(host.trajectory(), indexRange(50, -1)) < 0.07);
  }
  SECTION("twenty frames and back: never lost, and home again") {
    std::vector<int> order = indexRange(0, 21);
    for (const int k : indexRange(19, -1)) order.push_back(k);
    CHECK(clip.run(host, order) == 0);
    CHECK(host.trajectory().back().translation().norm() < 0.06);
  }
}

TEST_CASE("KITTI 06 with the right camera covered for two seconds: not lost, scale kept",
          "[data]") {
  const auto folder = test::dataOrSkip("kitti_clips/06");
  if (!folder) return;
  const KittiClip clip(*folder);
  test::Host host(clip.rig(), kExactRig);
  CHECK(clip.run(host, indexRange(0, 51), {15, 35}) == 0);
  CHECK(clip.ateRmse(host.trajectory(), indexRange(0, 51)) < 0.1);
}

TEST_CASE("KITTI raw 0001 with moving traffic ends as far away as its satellite positions say",
          "[data]") {
  const auto folder = test::dataOrSkip("kitti_clips/raw_0001");
  if (!folder) return;
  const KittiClip clip(*folder);
  test::Host host(clip.rig());
  CHECK(clip.run(host, indexRange(0, 108)) == 0);
  const Eigen::Vector3d way =
      host.trajectory().back().translation() - host.trajectory().front().translation();
  CHECK(way.norm() == Approx(107.0).epsilon(0.004));  // docs/report/odometry.md
}

TEST_CASE("without an offset KITTI raw 0001 is as long as systems without one say", "[data]") {
  const auto folder = test::dataOrSkip("kitti_clips/raw_0001");
  if (!folder) return;
  const KittiClip clip(*folder);
  test::Host host(clip.rig(), kExactRig);
  CHECK(clip.run(host, indexRange(0, 108)) == 0);
  CHECK(host.length() == Approx(108.1).epsilon(0.005));
}

TEST_CASE("KITTI 00 with one camera: starts early, is never lost", "[data]") {
  const auto folder = test::dataOrSkip("kitti_clips/00_left");
  if (!folder) return;
  const KittiClip clip(*folder);
  test::Host host(clip.rig(), {}, direct_sparse::Cameras::Single);
  CHECK(clip.run(host, indexRange(0, 120)) == 0);
  CHECK(clip.ateRmse(host.trajectory(), indexRange(0, 120), true) < 0.35);
}

TEST_CASE("KITTI 03 with one camera and JPEG images: never lost, its scale kept", "[data]") {
  const auto folder = test::dataOrSkip("kitti_clips/03_left");
  if (!folder) return;
  const KittiClip clip(*folder, ".jpg");
  test::Host host(clip.rig(), {}, direct_sparse::Cameras::Single);
  CHECK(clip.run(host, indexRange(0, 300)) == 0);
  CHECK(clip.ateRmse(host.trajectory(), indexRange(0, 300), true) < 3.1);  // of 210 m
}

TEST_CASE("a camera in a hand is tracked from its first motion, with no distance given", "[data]") {
  const auto folder = test::dataOrSkip("zed_hand");
  if (!folder) return;
  const KittiClip clip(*folder, ".jpg");
  test::Host host(clip.rig());
  CHECK(clip.run(host, indexRange(0, 40)) == 0);
  CHECK(host.length() == Approx(0.416).epsilon(0.03));  // of the camera's own tracking
}
