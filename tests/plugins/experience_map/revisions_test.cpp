// SPDX-License-Identifier: BSD-3-Clause
// Revisions of odometry give the same map as if the right motions had been given at once.
#include "map_fixture.hpp"

namespace tolman::experience_map {
namespace {

constexpr int kRevisedFrames = 160;

Eigen::Isometry3d rightStep(int k) { return step(1, k % 40 == 0 ? std::numbers::pi / 2 : 0.001); }
Eigen::Isometry3d wrongStep(int k) { return step(0.9 + 0.002 * k, k % 40 == 0 ? 1.4 : -0.01); }

/// A square driven once, with an experience every 8 m; ends on a loop when asked.
void decide(Fixture& fixture, const Motion& motion, int k, bool loop) {
  if (loop && k == kRevisedFrames - 10) {
    Decision decision = fixture.decision(Action::CloseLoop, 0);
    fixture.feed(motion, decision);
  } else if (k % 8 == 0) {
    fixture.feed(motion, fixture.decision(Action::CreateExperience, fixture.created++));
  } else {
    fixture.feed(motion, fixture.decision(Action::Stay, fixture.current));
  }
}

void drive(Fixture& fixture, bool right_from_start, bool loop) {
  for (int k = 0; k < kRevisedFrames; ++k) {
    Motion motion = fixture.motion(right_from_start ? rightStep(k) : wrongStep(k));
    for (int old = k - 10; !right_from_start && old <= k - 8; ++old) {  // overlapping windows
      if (old < 0) continue;
      motion.revisions.push_back({old, rightStep(old), motion.covariance});
    }
    decide(fixture, motion, k, loop);
  }
}

std::vector<MotionRevision> lastRevisions(const Fixture& fixture) {
  std::vector<MotionRevision> revisions;
  for (int k = kRevisedFrames - 8; k < kRevisedFrames; ++k) {
    revisions.push_back({k, rightStep(k), fixture.motion(step(0)).covariance});
  }
  return revisions;
}

void compare(bool loop, double tolerance) {
  Fixture late;
  Fixture right;
  drive(late, false, loop);
  drive(right, true, loop);
  REQUIRE(late.map.finish(lastRevisions(late)).isOk());
  REQUIRE(right.map.finish({}).isOk());
  for (int k = 0; k < kRevisedFrames; ++k) {
    REQUIRE(difference(late.poseOf(k), right.poseOf(k)) < tolerance);
  }
  const MapGraph a = late.graph();
  const MapGraph b = right.graph();
  REQUIRE(a.links.size() == b.links.size());
  for (std::size_t k = 0; k < a.links.size(); ++k) {
    REQUIRE(difference(a.links[k].T_from_to, b.links[k].T_from_to) < tolerance);
    REQUIRE((a.links[k].covariance - b.links[k].covariance).norm() <
            tolerance * (1 + b.links[k].covariance.norm()));
  }
}

}  // namespace

TEST_CASE("revised motions without loops equal right motions exactly") { compare(false, 1e-9); }

TEST_CASE("revised motions with a loop end at the optimum of right motions") {
  compare(true, 1e-4);
}

TEST_CASE("each revision of earlier poses makes a new version; plain frames do not") {
  Fixture fixture;
  fixture.create(step(0));
  fixture.stay(step(1));
  CHECK(fixture.stay(step(1)).version == 0);
  Motion motion = fixture.motion(step(1));
  motion.revisions.push_back({1, step(3), motion.covariance});
  const MapUpdate update = fixture.feed(motion, fixture.decision(Action::Stay, 0));
  CHECK(update.version == 1);
  CHECK(update.T_world_camera.translation().z() == Approx(5));
  CHECK(fixture.stay(step(1)).version == 1);
}

TEST_CASE("a revision of a frame that the map never saw is ignored, and said") {
  Fixture fixture;
  fixture.create(step(0));
  Motion motion = fixture.motion(step(1));
  motion.revisions.push_back({40, step(3), motion.covariance});
  CHECK(fixture.feed(motion, fixture.decision(Action::Stay, 0)).version == 0);
  REQUIRE(fixture.host.log.size() == 1);
  CHECK(fixture.host.log[0] == "ignored 1 revisions of frames that the map did not get");
}

}  // namespace tolman::experience_map
