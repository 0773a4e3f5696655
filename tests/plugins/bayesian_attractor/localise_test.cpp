// SPDX-License-Identifier: BSD-3-Clause
// Cells in a map that stays as it is: unknown until views agree, then found; carried away, unknown
// and found again.
#include <catch2/catch.hpp>
#include <numbers>
#include <sstream>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

constexpr int kViews = 60;  // on a ring road, 4 m apart
const PlanarPose kStep = {4, 0.02, 2 * std::numbers::pi / kViews};

std::string savedMap() {
  BayesianAttractor cells;
  REQUIRE(configure(cells, {}).isOk());
  for (int frame = 0; frame < kViews; ++frame) step(cells, motionOf(kStep, frame), novel(frame));
  std::ostringstream stream;
  REQUIRE(cells.save(stream).isOk());
  return stream.str();
}

/// Drives on the ring in the saved map; `view` is what is seen next.
struct Robot {
  Robot() {
    tolman::test::TestContext services;
    Context context = services;
    context.localise = true;
    REQUIRE(cells.configure(context).isOk());
    std::istringstream stream(savedMap());
    REQUIRE(cells.load(stream).isOk());
  }
  Decision drive(TrackingState state = TrackingState::Tracking) {
    Motion motion = motionOf(kStep, frame++);
    motion.state = state;
    if (state == TrackingState::Initialising) motion.T_previous_current.setIdentity();
    view = (view + 1) % kViews;
    return step(cells, motion, measured(view));
  }
  /// Frames until the place is known; it must be the right one.
  int search() {
    for (int frames = 0; frames < kViews; ++frames) {
      const Decision decision = drive();
      CHECK(decision.has_relative_pose == (decision.experience >= 0));
      if (!decision.has_relative_pose) continue;
      CHECK(decision.action == Action::CloseLoop);
      CHECK(decision.experience == view);  // each view made one
      return frames;
    }
    return -1;
  }
  std::size_t sizeOfState() const {
    std::ostringstream stream;
    REQUIRE(cells.save(stream).isOk());
    return stream.str().size();
  }

  BayesianAttractor cells;
  int frame = kViews;
  int view = 20;
};

}  // namespace

TEST_CASE("a place is unknown until several views agree, and then known at each frame") {
  Robot robot;
  CHECK_FALSE(robot.drive(TrackingState::Initialising).has_relative_pose);
  const int frames = robot.search();
  CHECK(frames >= 3);
  CHECK(frames <= 6);
  for (int frame = 0; frame < 3 * kViews; ++frame) {
    const Decision decision = robot.drive();
    CHECK(decision.has_relative_pose);
    CHECK(decision.action != Action::CreateExperience);
    CHECK(decision.covariance(2, 2) < 1);
  }
}

TEST_CASE("carried away, the place is unknown at once, and found again") {
  const bool noticed = GENERATE(true, false);  // by odometry
  Robot robot;
  robot.drive(TrackingState::Initialising);
  REQUIRE(robot.search() >= 0);
  robot.view = (robot.view + 30) % kViews;
  const auto state = noticed ? TrackingState::Initialising : TrackingState::Tracking;
  CHECK_FALSE(robot.drive(state).has_relative_pose);
  const int frames = robot.search();
  CHECK(frames >= 2);
  CHECK(frames <= 6);
}

TEST_CASE("without views the place becomes unknown again") {
  Robot robot;
  robot.drive(TrackingState::Initialising);
  REQUIRE(robot.search() >= 0);
  int frames = 0;
  while (step(robot.cells, motionOf(kStep, robot.frame++), nothing()).has_relative_pose) ++frames;
  CHECK(frames == 7);  // 30 m
}

TEST_CASE("memory does not grow while the robot localises itself") {
  Robot robot;
  robot.drive(TrackingState::Initialising);
  REQUIRE(robot.search() >= 0);
  const std::size_t size = robot.sizeOfState();
  for (int frame = 0; frame < 20 * kViews; ++frame) robot.drive();
  CHECK(robot.sizeOfState() == size);
}
