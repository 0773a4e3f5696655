// SPDX-License-Identifier: BSD-3-Clause
// The mirrored drive gives the mirrored map, with true and false loops.
#include <cmath>

#include "map_fixture.hpp"

using namespace tolman;
using namespace tolman::experience_map;

namespace {

struct Step {
  PlanarPose motion;
  Action action = Action::Stay;
  std::int64_t experience = 0;
  bool measured = false;
  PlanarPose offset;
};

/// A square driven twice with drift, loops on the second lap; every seventh of them false.
std::vector<Step> drive(std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Step> steps;
  std::int64_t made = 0;
  for (int k = 0; k < 160; ++k) {
    Step step;
    step.motion = {k == 0 ? 0 : 1.02, 0.01 * random.normal(),
                   k % 20 == 19 ? 1.6 : 0.003 * random.normal()};
    if (k % 4 == 0 && k < 80) {
      step.action = Action::CreateExperience;
      step.experience = made++;
    } else if (k >= 80 && k % 4 == 0) {
      step.action = Action::CloseLoop;
      step.experience = (k - 80) / 4;
      step.measured = random.below(3) != 0;
      step.offset = {0.1 * random.normal(), 0.1 * random.normal(), 0.01 * random.normal()};
      if (k % 28 == 0) step.offset.x += 6;
    }
    steps.push_back(step);
  }
  return steps;
}

/// Feeds the drive to a map, finishes it, and returns the planar poses of all frames.
std::vector<PlanarPose> mapOf(const std::vector<Step>& steps, MapGraph& graph) {
  Fixture f;
  f.covariance = isotropic(0.02, 0.002);
  std::int64_t here = -1;
  for (const Step& step : steps) {
    Decision decision =
        f.decision(step.action, step.action == Action::Stay ? here : step.experience);
    decision.relative_yaw = step.offset.theta;
    if (step.measured) {
      decision.has_relative_pose = true;
      decision.T_experience_current = fromPlanar(step.offset);
      decision.covariance = isotropic(0.1, 0.02);
    }
    here = f.feed(f.motion(fromPlanar(step.motion)), decision).experience;
  }
  REQUIRE(f.map.finish({}).isOk());
  std::vector<PlanarPose> poses;
  for (std::int64_t k = 0; k < f.frame; ++k) poses.push_back(toPlanar(f.poseOf(k)));
  graph = f.graph();
  return poses;
}

}  // namespace

TEST_CASE("a mirrored drive makes the mirrored map, with the same loops rejected") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::vector<Step> steps = drive(seed);
    std::vector<Step> other = steps;
    for (Step& step : other) {
      for (PlanarPose* pose : {&step.motion, &step.offset}) {
        *pose = {pose->x, -pose->y, -pose->theta};
      }
    }
    MapGraph a;
    MapGraph b;
    const std::vector<PlanarPose> poses = mapOf(steps, a);
    const std::vector<PlanarPose> mirrored = mapOf(other, b);
    CHECK(a.rejected == b.rejected);
    CHECK(a.links.size() == b.links.size());
    double off = 0;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      off = std::max(off, std::hypot(poses[k].x - mirrored[k].x, poses[k].y + mirrored[k].y));
    }
    CAPTURE(seed);
    CHECK(off < 1e-3);  // m; the optimiser stops at its tolerance
  }
}

TEST_CASE("loops bend the odometry: what is compared is more than dead reckoning") {
  MapGraph graph;
  const std::vector<Step> steps = drive(1);
  const std::vector<PlanarPose> poses = mapOf(steps, graph);
  PlanarPose reckoned;
  for (const Step& step : steps) reckoned = compose(reckoned, step.motion);
  CHECK(std::hypot(poses.back().x - reckoned.x, poses.back().y - reckoned.y) > 0.3);
  CHECK_FALSE(graph.rejected.empty());
}
