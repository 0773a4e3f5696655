// SPDX-License-Identifier: BSD-3-Clause
// The map as the host calls it: times, stamps, placement, and the error of RatSLAM's snapping.
#include "relaxation_map.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "support/context.hpp"

using namespace tolman;
using namespace tolman::relaxation;

namespace {

struct Fixture {
  Fixture() { REQUIRE(map.configure(services).isOk()); }
  MapUpdate feed(const PlanarPose& step, Action action, std::int64_t experience,
                 double relative_yaw = 0) {
    Motion motion;
    motion.frame = frame;
    motion.stamp_ns = 5 + frame * 1'000'000'000;
    motion.state = TrackingState::Tracking;
    motion.T_previous_current = fromPlanar(step);
    Decision decision;
    decision.frame = frame++;
    decision.action = action;
    decision.experience = experience;
    decision.relative_yaw = relative_yaw;
    MapUpdate update;
    const Status status = map.update(motion, decision, update);
    INFO(status.message());
    REQUIRE(status.isOk());
    REQUIRE(firstInvalidField(update).empty());
    return update;
  }
  PlanarPose poseOf(std::int64_t at) const {
    Eigen::Isometry3d T;
    REQUIRE(map.poseOf(at, T).isOk());
    return toPlanar(T);
  }
  MapGraph graph() const {
    MapGraph graph;
    REQUIRE(map.graph(graph).isOk());
    return graph;
  }
  test::TestContext services{{}};
  RelaxationMap map;
  std::int64_t frame = 0;
};

constexpr PlanarPose kCorner = {10, 0, std::numbers::pi / 2};

}  // namespace

TEST_CASE("without loops the map is the odometry") {
  Fixture fixture;
  PlanarPose reckoned;
  fixture.feed({}, Action::CreateExperience, 0);
  for (int k = 1; k < 60; ++k) {
    const PlanarPose step = {1, 0.05, 0.03};
    reckoned = compose(reckoned, step);
    const MapUpdate update = k % 5 == 0 ? fixture.feed(step, Action::CreateExperience, k / 5)
                                        : fixture.feed(step, Action::Stay, k / 5);
    CHECK(toPlanar(update.T_world_camera).x == Approx(reckoned.x));
    CHECK(update.stamp_ns == 5 + k * 1'000'000'000LL);  // defect 9: never the clock's
  }
  CHECK(fixture.poseOf(59).y == Approx(reckoned.y));
}

TEST_CASE("the time of a link is that between its ends, not since the start (defect 7)") {
  Fixture fixture;
  fixture.feed({}, Action::CreateExperience, 0);
  for (int k = 1; k <= 30; ++k) {
    const bool makes = k % 3 == 0;
    fixture.feed({1, 0, 0}, makes ? Action::CreateExperience : Action::Stay, makes ? k / 3 : k / 3);
  }
  for (const Link& link : fixture.graph().links) CHECK(link.duration == Approx(3));
}

TEST_CASE("a square that does not close is pulled together, the start staying the start") {
  Fixture fixture;
  fixture.feed({}, Action::CreateExperience, 0);
  for (int k = 1; k < 4; ++k) {
    fixture.feed(compose(kCorner, {0, 0, 0.05}), Action::CreateExperience, k);
  }
  const MapUpdate closed = fixture.feed(compose(kCorner, {0, 0, 0.05}), Action::CloseLoop, 0);
  CHECK(closed.loops == 1);
  CHECK(closed.experience == 0);
  CHECK(fixture.poseOf(0).x == Approx(0).margin(1e-12));
  const PlanarPose third = fixture.poseOf(3);
  CHECK(std::hypot(third.x, third.y - 10) < 1.2);  // 1.5 m off by odometry
  CHECK(fixture.graph().links.back().kind == LinkKind::Loop);
}

TEST_CASE("the robot is put onto the old experience: what made good odometry worse") {
  Fixture fixture;
  fixture.feed({}, Action::CreateExperience, 0);
  fixture.feed({10, 0, 0}, Action::CreateExperience, 1);
  // Really at (3, 1), says odometry rightly; the loop says "at experience 0".
  fixture.feed({-7, 1, 0}, Action::CloseLoop, 0, 0.2);
  CHECK(std::hypot(fixture.poseOf(2).x, fixture.poseOf(2).y) < 1e-9);
  CHECK(fixture.poseOf(2).theta == Approx(0.2));
  // And the same loop again is no new link.
  fixture.feed({1, 0, 0}, Action::CloseLoop, 0);
  CHECK(fixture.graph().links.size() == 1);
}

TEST_CASE("impossible decisions and unknown frames are refused with the reason") {
  Fixture fixture;
  fixture.feed({}, Action::CreateExperience, 0);
  Motion motion;
  motion.frame = 1;
  Decision decision;
  decision.frame = 1;
  decision.action = Action::CloseLoop;
  decision.experience = 7;
  MapUpdate update;
  CHECK(fixture.map.update(motion, decision, update).message() ==
        "the decision (close_loop) names experience 7, but there are 1");
  motion.frame = 0;
  CHECK(fixture.map.update(motion, decision, update).code() == StatusCode::InvalidInput);
  Eigen::Isometry3d T;
  CHECK(fixture.map.poseOf(3, T).code() == StatusCode::InvalidParameter);
}
