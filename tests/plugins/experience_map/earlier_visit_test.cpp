// SPDX-License-Identifier: BSD-3-Clause
// Loops that become known later give the same map as if they had been known at once.
#include <sstream>

#include "map_fixture.hpp"

namespace tolman::experience_map {
namespace {

constexpr int kWalkFrames = 241;

/// With an odometry whose covariance fits its drift.
struct HonestFixture : Fixture {
  HonestFixture() { covariance = isotropic(0.02, 0.005); }
};

/// Steps of 1 m around a square of 20 m sides, by an odometry that turns too far.
Eigen::Isometry3d drifting(int k) {
  return step(1, (k % 20 == 0 ? std::numbers::pi / 2 : 0) + 0.0005);
}

EarlierLoop loopAt(std::int64_t frame) {
  return {frame, frame % 80 / 5, Eigen::Isometry3d::Identity(), isotropic(0.01, 0.01)};
}

/// Three laps with an experience every 5 m of the first one, and a loop every 10 m of the others.
/// Each loop at its own frame, or all loops of 40 m with the last of them.
MapUpdate threeLaps(Fixture& fixture, bool late) {
  std::vector<EarlierLoop> waiting;
  MapUpdate update = fixture.create(step(0));
  for (int k = 1; k < kWalkFrames; ++k) {
    if (k < 80 && k % 5 == 0) {
      update = fixture.create(drifting(k));
    } else if (k <= 80 || k % 10 != 0) {
      update = fixture.stay(drifting(k));
    } else if (late && k % 40 != 0) {
      waiting.push_back(loopAt(k));
      update = fixture.stay(drifting(k));
    } else {
      const EarlierLoop loop = loopAt(k);
      Decision decision = fixture.decision(Action::CloseLoop, loop.experience);
      decision.has_relative_pose = true;
      decision.covariance = loop.covariance;
      decision.earlier = std::exchange(waiting, {});
      update = fixture.feed(fixture.motion(drifting(k)), decision);
    }
    const MapGraph graph = fixture.graph();
    REQUIRE(update.links == static_cast<std::int64_t>(graph.links.size()));
  }
  return update;
}

Status tell(Fixture& fixture, const EarlierLoop& loop) {
  Decision decision = fixture.decision(Action::Stay, fixture.current);
  decision.earlier = {loop};
  MapUpdate update;
  return fixture.map.update(fixture.motion(step(1)), decision, update);
}

}  // namespace

TEST_CASE("loops told later give the map that they would have given at once") {
  HonestFixture at_once;
  HonestFixture later;
  const MapUpdate a = threeLaps(at_once, false);
  const MapUpdate b = threeLaps(later, true);
  CHECK(a.loops == b.loops);
  REQUIRE(at_once.map.finish({}).isOk());
  REQUIRE(later.map.finish({}).isOk());
  for (int k = 0; k < kWalkFrames; ++k) {
    REQUIRE(distance(at_once.poseOf(k), later.poseOf(k)) < 1e-4);
  }
  const MapGraph x = at_once.graph();
  const MapGraph y = later.graph();
  REQUIRE(x.links.size() == y.links.size());
  for (std::size_t i = 0; i < x.links.size(); ++i) {
    CHECK(x.links[i].from == y.links[i].from);
    CHECK(x.links[i].to == y.links[i].to);
    CHECK(x.links[i].frame == y.links[i].frame);
    CHECK(x.links[i].kind == y.links[i].kind);
  }
}

TEST_CASE("loops told with a decision of any action count") {
  HonestFixture fixture;
  fixture.create(step(0));
  for (int k = 1; k < 80; ++k) k % 5 == 0 ? fixture.create(drifting(k)) : fixture.stay(drifting(k));
  fixture.stay(drifting(80));
  const double before = fixture.poseOf(80).translation().norm();
  Decision decision = fixture.decision(Action::CreateExperience, fixture.created++);
  decision.earlier = {loopAt(80)};
  const MapUpdate update = fixture.feed(fixture.motion(drifting(81)), decision);
  CHECK(update.loops == 1);
  CHECK(before > 0.3);
  CHECK(fixture.poseOf(80).translation().norm() < 0.5 * before);
}

TEST_CASE("a frame's loop is taken once") {
  Fixture fixture;
  fixture.create(step(0));
  for (int k = 1; k < 80; ++k) k % 5 == 0 ? fixture.create(drifting(k)) : fixture.stay(drifting(k));
  fixture.stay(drifting(80));
  for (int k = 81; k < 84; ++k) {
    Decision decision = fixture.decision(Action::Stay, fixture.current);
    decision.earlier = {loopAt(80)};
    CHECK(fixture.feed(fixture.motion(drifting(k)), decision).loops == 1);
  }
}

TEST_CASE("an earlier loop alone joins two parts of the path") {
  Fixture fixture;
  fixture.create(step(0));
  for (int k = 1; k < 30; ++k) k % 5 == 0 ? fixture.create(step(1)) : fixture.stay(step(1));
  Motion carried = fixture.motion(step(0));
  carried.state = TrackingState::Initialising;
  fixture.feed(carried, fixture.decision(Action::CreateExperience, fixture.created++));
  for (int k = 0; k < 6; ++k) fixture.stay(step(1));
  Decision decision = fixture.decision(Action::Stay, fixture.current);
  decision.earlier = {{33, 2, Eigen::Isometry3d::Identity(), isotropic(0.01, 0.01)}};
  fixture.feed(fixture.motion(step(1)), decision);
  REQUIRE(fixture.map.finish({}).isOk());
  CHECK(fixture.poseOf(33).translation().z() == Approx(10).margin(0.01));
  CHECK(fixture.poseOf(37).translation().z() == Approx(14).margin(0.01));
}

TEST_CASE("a map with inserted visits is saved and goes on as it would") {
  HonestFixture saved;
  threeLaps(saved, true);
  std::stringstream stream;
  REQUIRE(saved.map.save(stream).isOk());
  HonestFixture loaded;
  REQUIRE(loaded.map.load(stream).isOk());
  loaded.frame = saved.frame;
  const MapUpdate a = saved.closeMeasured(drifting(kWalkFrames), 0, step(0));
  const MapUpdate b = loaded.closeMeasured(drifting(kWalkFrames), 0, step(0));
  CHECK(difference(a.T_world_camera, b.T_world_camera) < 1e-9);
  CHECK(a.loops == b.loops);
}

TEST_CASE("an experience that did not exist then is refused, an unknown frame is ignored") {
  Fixture fixture;
  fixture.create(step(0));
  for (int k = 1; k < 20; ++k) k % 5 == 0 ? fixture.create(step(1)) : fixture.stay(step(1));
  CHECK(tell(fixture, {7, 3, Eigen::Isometry3d::Identity(), isotropic(1, 1)}).message() ==
        "the decision has a loop of frame 7 to experience 3, which did not exist then");
  CHECK(tell(fixture, {7, 9, Eigen::Isometry3d::Identity(), isotropic(1, 1)}).message() ==
        "the decision has a loop of frame 7 to experience 9, which did not exist then");
  CHECK(tell(fixture, {-5, 0, Eigen::Isometry3d::Identity(), isotropic(1, 1)}).isOk());
}

}  // namespace tolman::experience_map
