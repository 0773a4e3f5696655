// SPDX-License-Identifier: BSD-3-Clause
// A drive round a block of the town, whose turns and speed are known.
#include <catch2/catch.hpp>

#include "harness.hpp"
#include "town_source.hpp"

using namespace tolman;
using namespace tolman::scanline::test;

namespace {

struct Drive {
  double true_turn = 0;  ///< rad, summed
  double turn = 0;
  double true_way = 0;
  double way = 0;
  double squares = 0;  ///< of the turns' errors
  int frames = 0;
};

/// One camera at a quarter of KITTI's size; frames first to last of the route.
Drive drive(std::int64_t first, std::int64_t last) {
  tolman::test::TestContext context(
      {{"scale", 0.25}, {"first", first}, {"last", last}, {"mono", true}});
  town::TownSource source;
  const Status status = source.configure(context);
  INFO(status.message());
  REQUIRE(status.isOk());
  SourceInfo info;
  REQUIRE(source.info(info).isOk());
  Host host(info.rig);
  Drive drive;
  Eigen::Isometry3d before = Eigen::Isometry3d::Identity();
  for (Frame frame; source.next(frame).isOk(); frame = {}) {
    const Motion motion = host.see(frame.left);
    const PlanarPose truth = toPlanar(before.inverse() * frame.T_world_camera_truth);
    before = frame.T_world_camera_truth;
    if (drive.frames++ == 0) continue;
    const PlanarPose step = toPlanar(motion.T_previous_current);
    drive.true_turn += truth.theta;
    drive.turn += step.theta;
    drive.true_way += std::hypot(truth.x, truth.y);
    drive.way += std::hypot(step.x, step.y);
    drive.squares += (step.theta - truth.theta) * (step.theta - truth.theta);
  }
  return drive;
}

}  // namespace

TEST_CASE("town: turns are measured, the way roughly") {
  const Drive result = drive(0, 160);
  WARN("town: turn " << result.turn << " of " << result.true_turn << " rad, way " << result.way
                     << " of " << result.true_way << " m, "
                     << std::sqrt(result.squares / result.frames) << " rad a frame");
  REQUIRE(std::abs(result.true_turn) > 1);
  CHECK(result.turn == Approx(result.true_turn).epsilon(0.2));
  CHECK(std::sqrt(result.squares / result.frames) < 0.01);
  // The scale was fitted to real streets: within a factor of two here.
  CHECK(result.way > 0.5 * result.true_way);
  CHECK(result.way < 2 * result.true_way);
}
