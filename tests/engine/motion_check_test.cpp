// SPDX-License-Identifier: BSD-3-Clause
// Which motions are possible, and the handling of others.
#include "engine/checked_odometry.hpp"
#include "engine/toy_stages.hpp"

using namespace tolman;
using namespace tolman::engine;

namespace {

Motion forward(double metres, double dt = 0.1) {
  Motion motion;
  motion.state = TrackingState::Tracking;
  motion.T_previous_current.translation().z() = metres;
  motion.dt = dt;
  return motion;
}

bool isPossible(MotionCheck& check, const Motion& motion) { return !check.check(motion); }

}  // namespace

TEST_CASE("a car that brakes and turns as hard as it can is possible") {
  MotionCheck check{config::CheckSettings()};
  for (double v = 0; v < 40; v += 0.5) CHECK(isPossible(check, forward(0.1 * v)));
  for (double v = 40; v > 0; v -= 1) {
    Motion motion = forward(0.1 * v);
    motion.T_previous_current.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()));
    CHECK(isPossible(check, motion));
  }
}

TEST_CASE("speed, turn rate and acceleration have limits, and the reason names them") {
  MotionCheck check{config::CheckSettings()};
  CHECK(check.check(forward(142)).value() == "has a speed of 1420 m/s; checks.max_speed is 100");
  Motion turning = forward(1);
  turning.T_previous_current.rotate(Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitX()));
  CHECK(
      check.check(turning).value().starts_with("turns by 15.0 rad/s; checks.max_turn_rate is 10"));
  CHECK(isPossible(check, forward(1)));
  CHECK(isPossible(check, forward(-1)));  // a clip that is played to and fro
  const auto jump = check.check(forward(2)).value();
  CHECK(jump.starts_with("changes its speed by 10.0 m/s in"));
  CHECK(jump.find("checks.max_acceleration is 50 m/s^2") != std::string::npos);
}

TEST_CASE("what is impossible at once is possible after a while") {
  MotionCheck check{config::CheckSettings()};
  CHECK(isPossible(check, forward(1)));
  CHECK_FALSE(isPossible(check, forward(3)));  // 20 m/s more after 0.1 s
  CHECK_FALSE(isPossible(check, forward(3)));
  CHECK_FALSE(isPossible(check, forward(3)));
  CHECK(isPossible(check, forward(3)));  // after 0.4 s
}

TEST_CASE(
    "only the turn rate is checked where the scale is unknown, nothing where nothing is told") {
  MotionCheck check{config::CheckSettings()};
  Motion scaleless = forward(500);
  scaleless.scale_known = false;
  CHECK(isPossible(check, scaleless));
  scaleless.T_previous_current.rotate(Eigen::AngleAxisd(2, Eigen::Vector3d::UnitX()));
  CHECK_FALSE(isPossible(check, scaleless));
  Motion lost = forward(500);
  lost.state = TrackingState::Lost;
  CHECK(isPossible(check, lost));
  CHECK(isPossible(check, forward(1, 0)));
}

TEST_CASE("after a new start no velocity is known") {
  MotionCheck check{config::CheckSettings()};
  CHECK(isPossible(check, forward(1)));
  Motion start = forward(0);
  start.state = TrackingState::Initialising;
  CHECK(isPossible(check, start));
  CHECK(isPossible(check, forward(4)));
}

TEST_CASE("small errors of positions do not count at high frame rates") {
  MotionCheck check{config::CheckSettings()};
  RandomStream random(3);
  for (int i = 0; i < 500; ++i) {
    CHECK(isPossible(check, forward(0.001 + random.uniform(-0.02, 0.02), 0.001)));
  }
}

TEST_CASE(
    "an impossible motion becomes a prediction in state lost, and its revisions are dropped") {
  test::Hooks hooks;
  host::OdometryStage stage(test::guardedToy<test::LeapingOdometry>(hooks, "odometry"));
  CheckedOdometry odometry(stage, config::CheckSettings());
  for (std::int64_t i = 0; i < 6; ++i) {
    Frame frame;
    frame.frame = i;
    frame.stamp_ns = i * 100'000'000;
    Motion motion;
    std::vector<std::string> impossible;
    REQUIRE(odometry.track(frame, motion, impossible).isOk());
    CAPTURE(i);
    REQUIRE(impossible.size() == (i == 3 ? 1U : 0U));
    if (i == 3) CHECK(impossible[0].starts_with("the motion "));
    CHECK(motion.frame == i);
    CHECK(motion.dt == Approx(i == 0 ? 0 : 0.1));
    if (i == 3) {
      CHECK(motion.state == TrackingState::Lost);
      CHECK(motion.T_previous_current.translation().z() == 1);  // as before
      CHECK(motion.covariance(0, 0) >= 1);
    }
    for (const MotionRevision& revision : motion.revisions) CHECK(revision.frame != 3);
    CHECK(motion.revisions.size() == (i == 4 ? 0U : i > 0 ? 1U : 0U));
  }
  std::vector<MotionRevision> revisions;
  std::vector<std::string> impossible;
  REQUIRE(odometry.finish(revisions, impossible).isOk());
  CHECK(revisions.size() == 1);  // of frame 2; that of frame 3 is dropped
}

TEST_CASE("a revision is as possible as a motion has to be") {
  const MotionCheck check{config::CheckSettings()};
  MotionRevision revision;
  revision.T_previous_current.translation().z() = 2;
  CHECK_FALSE(check.checkRevision(revision, 0.1, true));
  revision.T_previous_current.translation().z() = 500;
  CHECK(check.checkRevision(revision, 0.1, true)->starts_with("has a speed of 5000 m/s"));
  CHECK_FALSE(check.checkRevision(revision, 0.1, false));
  CHECK_FALSE(check.checkRevision(revision, 0, true));
  revision.T_previous_current.rotate(Eigen::AngleAxisd(2, Eigen::Vector3d::UnitX()));
  CHECK(check.checkRevision(revision, 0.1, false)->starts_with("turns by 20.0 rad/s"));
}
