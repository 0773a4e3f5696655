// SPDX-License-Identifier: BSD-3-Clause
// Real stereo images, if available: the error against the truth, and the lengths of paths.
#include <catch2/catch.hpp>

#include "feature_stereo.hpp"
#include "support/data.hpp"
#include "support/kitti_clip.hpp"

using namespace tolman;
using test::indexRange;

namespace {

using Host = test::OdometryHost<feature_stereo::FeatureStereo>;

}  // namespace

TEST_CASE("KITTI 06, forwards, backwards and back again", "[data]") {
  const auto folder = test::dataOrSkip("kitti_clips/06");
  if (!folder) return;
  const test::KittiClip clip(*folder);
  Host host(clip.rig());
  SECTION("forwards") {
    CHECK(clip.run(host, indexRange(0, 51)) == 0);
    CHECK(clip.ateRmse(host.trajectory(), indexRange(0, 51)) < 0.20);
  }
  SECTION("backwards") {
    CHECK(clip.run(host, indexRange(50, -1)) == 0);
    CHECK(clip.ateRmse(host.trajectory(), indexRange(50, -1)) < 0.20);
  }
  SECTION("ten frames and back: never lost, and home again") {
    std::vector<int> order = indexRange(0, 11);
    for (const int k : indexRange(9, -1)) order.push_back(k);
    CHECK(clip.run(host, order) == 0);
    CHECK(host.trajectory().back().translation().norm() < 0.10);
  }
}

TEST_CASE("KITTI raw 0001 with moving traffic has the length that others agree on", "[data]") {
  const auto folder = test::dataOrSkip("kitti_clips/raw_0001");
  if (!folder) return;
  const test::KittiClip clip(*folder);
  Host host(clip.rig());
  CHECK(clip.run(host, indexRange(0, 108)) == 0);
  CHECK(host.length() == Approx(108.1).epsilon(0.01));
}

TEST_CASE("a camera in a hand is tracked from its first motion, with no distance given", "[data]") {
  const auto folder = test::dataOrSkip("zed_hand");
  if (!folder) return;
  const test::KittiClip clip(*folder, ".jpg");
  Host host(clip.rig());
  CHECK(clip.run(host, indexRange(0, 40)) == 0);
  CHECK(host.length() == Approx(0.416).epsilon(0.03));  // of the camera's own tracking
}
