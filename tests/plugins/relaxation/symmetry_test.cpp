// SPDX-License-Identifier: BSD-3-Clause
// The mirrored drive gives the mirrored map.
#include <catch2/catch.hpp>

#include "relaxation_map.hpp"
#include "support/context.hpp"

using namespace tolman;
using namespace tolman::relaxation;

namespace {

/// Feeds a square of two laps, `side` 1 to the left or -1 to the right; returns all poses.
std::vector<PlanarPose> drive(std::uint64_t seed, double side) {
  RandomStream random(seed);
  test::TestContext services{{}};
  RelaxationMap map;
  REQUIRE(map.configure(services).isOk());
  std::int64_t made = 0;
  std::int64_t here = -1;
  constexpr std::int64_t kFrames = 120;
  for (std::int64_t k = 0; k < kFrames; ++k) {
    const double sideways = 0.02 * random.normal();
    const double turn = k % 15 == 14 ? 1.62 : 0.01 * random.normal();
    Motion motion;
    motion.frame = k;
    motion.stamp_ns = k * 100'000'000;
    motion.state = TrackingState::Tracking;
    motion.T_previous_current = fromPlanar({k == 0 ? 0.0 : 1.0, side * sideways, side * turn});
    Decision decision;
    decision.frame = k;
    decision.action = k % 5 != 0 ? Action::Stay
                      : k < 60   ? Action::CreateExperience
                                 : Action::CloseLoop;
    decision.experience = k % 5 != 0 ? here : k < 60 ? made++ : (k - 60) / 5;
    if (k >= 60) decision.relative_yaw = side * 0.05 * random.normal();
    here = decision.experience;
    MapUpdate update;
    const Status status = map.update(motion, decision, update);
    INFO(k << ": " << status.message());
    REQUIRE(status.isOk());
    here = update.experience;
  }
  REQUIRE(map.finish({}).isOk());
  std::vector<PlanarPose> poses;
  for (std::int64_t k = 0; k < kFrames; ++k) {
    Eigen::Isometry3d T;
    REQUIRE(map.poseOf(k, T).isOk());
    poses.push_back(toPlanar(T));
  }
  return poses;
}

}  // namespace

TEST_CASE("a drive to the right makes the map of the drive to the left, mirrored") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const std::vector<PlanarPose> left = drive(seed, 1);
    const std::vector<PlanarPose> right = drive(seed, -1);
    double widest = 0;
    for (std::size_t k = 0; k < left.size(); ++k) {
      CAPTURE(seed, k);
      REQUIRE(left[k].x == Approx(right[k].x).margin(1e-6));
      REQUIRE(left[k].y == Approx(-right[k].y).margin(1e-6));
      REQUIRE(std::cos(left[k].theta) == Approx(std::cos(right[k].theta)).margin(1e-6));
      widest = std::max(widest, std::abs(left[k].y));
    }
    CHECK(widest > 5);  // a square, not a line
  }
}
