// SPDX-License-Identifier: BSD-3-Clause
// Waking up somewhere: views judge each other.
#include "relocation.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

PlaceObservation measured(std::int64_t id, const PlanarPose& pose = {}) {
  PlaceObservation seen = familiar(id);
  seen.has_relative_pose = true;
  seen.T_template_current = fromPlanar(pose);
  seen.covariance.diagonal().setConstant(0.01);
  return seen;
}

/// A winding road: frame k is 4 m after frame k - 1.
struct Robot {
  Robot() { REQUIRE(configure(plugin, {}).isOk()); }

  Decision drive(int k, const PlaceObservation& seen) {
    Motion motion = motionOf({4, 0, 0.1 * ((k / 20) % 3 - 1)}, frame++);
    motion.covariance.diagonal().setConstant(1e-4);
    return step(plugin, motion, seen);
  }
  Decision wakeUp(const PlaceObservation& seen) {
    Motion motion = motionOf({0, 0, 0}, frame++);
    motion.state = TrackingState::Initialising;
    return step(plugin, motion, seen);
  }
  /// The first session: 200 frames, each with its own template.
  void learn() {
    for (int k = 0; k < 200; ++k) drive(k, novel(k));
  }

  BayesianAttractor plugin;
  std::int64_t frame = 0;
};

}  // namespace

TEST_CASE("after a gap a new experience is made, wherever the robot is") {
  Robot robot;
  robot.learn();
  const Decision last = robot.drive(200, nothing());
  const Decision woken = robot.wakeUp(nothing());
  CHECK(woken.action == Action::CreateExperience);
  CHECK(woken.experience >= last.experience + 1);
  const Decision next = robot.wakeUp(nothing());  // still initialising: no second gap
  CHECK(next.action == Action::Stay);
}

TEST_CASE("the third of three views that agree closes the loop, with its measured pose") {
  Robot robot;
  robot.learn();
  robot.wakeUp(nothing());
  std::vector<int> closed;
  for (int k = 60; k < 80; ++k) {
    const Decision d = robot.drive(k, k % 2 == 0 ? measured(k, {0.5, 0, 0}) : nothing());
    if (d.action != Action::CloseLoop) continue;
    closed.push_back(k);
    CHECK(d.has_relative_pose);
  }
  REQUIRE_FALSE(closed.empty());
  CHECK(closed.front() == 64);  // views at 60, 62, 64, each 8 m apart
  CHECK(closed.size() > 5);     // and then each view decides
}

TEST_CASE("look-alikes that contradict each other close nothing, however many") {
  Robot robot;
  robot.learn();
  robot.wakeUp(nothing());
  RandomStream random(7);
  for (int k = 60; k < 160; ++k) {
    const auto any = static_cast<std::int64_t>(random.below(190));
    CHECK(robot.drive(k, measured(any)).action != Action::CloseLoop);
  }
}

TEST_CASE("one look-alike again and again, on the spot, counts once") {
  PathMemory memory({});
  for (int k = 0; k < 50; ++k) memory.advance({4, 0, 0.01}, 1e-4, 1e-6);
  const PathMark learned = memory.now();
  for (int k = 0; k < 50; ++k) memory.advance({4, 0, 0.01}, 1e-4, 1e-6);
  memory.startPart();
  CHECK_FALSE(memory.reaches(learned));
  const ViewEvidence evidence({});
  Relocation relocation({.views = 3, .spacing = 5});
  UncertainStep seen;
  seen.covariance.diagonal() << 1, 1, 0.01;
  for (int k = 0; k < 20; ++k) {
    memory.advance({0.01, 0, 0}, 1e-6, 1e-8);
    CHECK_FALSE(relocation.agrees(memory, evidence, learned, seen));
  }
  CHECK(relocation.claims().size() == 20);
}

TEST_CASE("a loop over a gap is a way to the past, and is not forgotten for loops within a part") {
  PathMemory memory({});
  for (int k = 0; k < 10; ++k) memory.advance({4, 0, 0}, 1e-4, 1e-6);
  const PathMark old = memory.now();
  memory.startPart();
  memory.advance({4, 0, 0}, 1e-4, 1e-6);
  UncertainStep seen{{1, 2, 0.3}, Eigen::Matrix3d::Identity() * 0.01};
  memory.close(old, seen, 16);
  REQUIRE(memory.reaches(old));
  CHECK(memory.predict(old).pose.x == Approx(1));
  CHECK(memory.predict(old).pose.y == Approx(2));
  for (int k = 0; k < 150; ++k) {
    const PathMark home = memory.now();
    memory.advance({4, 0, 0}, 1e-4, 1e-6);
    memory.close(home, {{4, 0, 0}, Eigen::Matrix3d::Identity()}, 16);
  }
  CHECK(memory.reaches(old));
  CHECK(memory.state().loops.size() <= 101);
}

TEST_CASE("cells that are saved while they look for where they are go on looking") {
  Robot saved;
  saved.learn();
  saved.wakeUp(nothing());
  saved.drive(60, measured(60));
  saved.drive(61, nothing());
  saved.drive(62, measured(62));
  std::stringstream stream;
  REQUIRE(saved.plugin.save(stream).isOk());
  Robot loaded;
  REQUIRE(loaded.plugin.load(stream).isOk());
  loaded.frame = saved.frame;
  for (int k = 63; k < 90; ++k) {
    const auto seen = k % 2 == 0 ? measured(k) : nothing();
    const Decision a = saved.drive(k, seen);
    const Decision b = loaded.drive(k, seen);
    CHECK(a.action == b.action);
    CHECK(a.experience == b.experience);
    CHECK(a.T_experience_current.matrix() == b.T_experience_current.matrix());
    CHECK(a.heading == b.heading);
  }
}
