// SPDX-License-Identifier: BSD-3-Clause
// Claims that a place is passed in the opposite direction, on a street that is driven out and back.
#include <catch2/catch.hpp>
#include <numbers>

#include "experiment/bench.hpp"

using namespace tolman;
using namespace tolman::experiment;

namespace {

/// 60 m out, one image a metre, then back 3 m to the left; image 61 + i passes image 60 - i.
evaluation::Trajectory outAndBack() {
  evaluation::Trajectory path;
  for (int i = 0; i <= 60; ++i) path.push_back({i, i, fromPlanar({1.0 * i, 0, 0})});
  for (int i = 0; i <= 60; ++i) {
    path.push_back({61 + i, 61 + i, fromPlanar({60.0 - i, 3, std::numbers::pi})});
  }
  return path;
}

/// That `query` is 3 m beside `place`, looking back, and `wrong` m too far ahead of it.
evaluation::PlaceClaim beside(std::int64_t query, std::int64_t place, double wrong = 0) {
  return {query, place, 0.1, false, fromPlanar({wrong, 3, std::numbers::pi})};
}

}  // namespace

TEST_CASE("an observation is turned when its yaw is more than a right angle") {
  PlaceObservation seen;
  for (const double yaw : {0.0, 1.5, -1.5, 2 * std::numbers::pi}) {
    seen.relative_yaw = yaw;
    CHECK_FALSE(isTurned(seen));
  }
  for (const double yaw : {1.6, -1.6, 3.1, -3.1}) {
    seen.relative_yaw = yaw;
    CHECK(isTurned(seen));
  }
}

TEST_CASE("the claimed pose is the measured one, or the template turned by the yaw") {
  PlaceObservation seen;
  seen.relative_yaw = 3;
  CHECK(claimedPose(seen).isApprox(fromPlanar({0, 0, 3})));
  seen.has_relative_pose = true;
  seen.T_template_current = fromPlanar({2, 3, -3});
  CHECK(claimedPose(seen).isApprox(fromPlanar({2, 3, -3})));
}

TEST_CASE("a claim on another storey is wrong where a height is given") {
  evaluation::Trajectory path = outAndBack();
  for (int i = 61; i < 122; ++i) path[i].T_world_camera.translation().y() -= 2;
  const std::vector<evaluation::PlaceClaim> claims = {beside(101, 20)};
  CHECK(judgeOpposite(path, claims).claims[0].right);
  CHECK_FALSE(judgeOpposite(path, claims, 1.5).claims[0].right);
  CHECK(judgeOpposite(path, claims, 1.5).findable == 0);
}

TEST_CASE("a claim is right when the claimed position is near the true one, the other way") {
  const auto places = judgeOpposite(
      outAndBack(),
      {beside(101, 20), beside(101, 20, 4), beside(101, 20, 6), beside(101, 40), beside(50, 20)});
  REQUIRE(places.claims.size() == 5);
  CHECK(places.claims[0].right);
  CHECK(places.claims[0].error_m == Approx(0).margin(1e-9));
  CHECK(places.claims[1].right);
  CHECK(places.claims[1].error_m == Approx(4));
  CHECK_FALSE(places.claims[2].right);
  CHECK_FALSE(places.claims[3].right);
  CHECK(places.claims[3].error_m == Approx(20));
  CHECK_FALSE(places.claims[4].right);  // the same direction
  CHECK(places.right() == 2);
  CHECK(places.medianError() == Approx(4));
}

TEST_CASE("images are findable when they pass a place the other way, and found for five metres") {
  const auto none = judgeOpposite(outAndBack(), {});
  // More than 20 m of path must lie between: i back and i ahead of the turn, which takes 3 m, and
  // 4 m more to the farthest image within 5 m. That leaves out the first seven.
  CHECK(none.findable == 54);
  CHECK(none.found == 0);
  CHECK(none.medianError() == 0);
  CHECK(judgeOpposite(outAndBack(), {beside(101, 20)}).found == 6);  // 101 to 106
  CHECK(judgeOpposite(outAndBack(), {beside(101, 20), beside(103, 18)}).found == 8);
  CHECK(judgeOpposite(outAndBack(), {beside(101, 40)}).found == 0);
}

TEST_CASE("an image that returns in both directions is no question of this measure") {
  evaluation::Trajectory path = outAndBack();
  for (int i = 0; i <= 60; ++i) path.push_back({122 + i, 122 + i, fromPlanar({1.0 * i, 3, 0})});
  // The third pass has the first one in its direction; the second one is findable as before.
  const auto both = judgeOpposite(path, {});
  CHECK(both.findable == judgeOpposite(outAndBack(), {}).findable);
}
