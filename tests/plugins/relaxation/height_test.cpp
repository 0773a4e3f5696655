// SPDX-License-Identifier: BSD-3-Clause
// The map in four degrees of freedom: loops correct drift of height over a hill; without the
// parameter all heights are zero.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "relaxation_map.hpp"
#include "support/context.hpp"

using namespace tolman;
using namespace tolman::relaxation;

namespace {

constexpr int kLap = 40;

/// Camera level, on a circle of 100 m with a hill of 6 m.
Eigen::Isometry3d truthAt(int k) {
  const double angle = 2 * std::numbers::pi * k / kLap;
  Eigen::Isometry3d T = fromPlanar({16 * std::sin(angle), 16 - 16 * std::cos(angle), angle});
  T.translation().y() = -3 * (1 - std::cos(angle));
  return T;
}

/// `laps` laps, an experience every fourth frame of the first, loops to them later; odometry sinks
/// by `sinks` m a frame.
std::vector<Eigen::Isometry3d> drive(bool height, int laps, double sinks) {
  test::TestContext services({{"height", height}, {"sweeps", std::int64_t{200}}});
  RelaxationMap map;
  REQUIRE(map.configure(services).isOk());
  std::int64_t here = -1;
  for (int k = 0; k <= laps * kLap; ++k) {
    Motion motion;
    motion.frame = k;
    motion.stamp_ns = k * 100'000'000LL;
    motion.state = TrackingState::Tracking;
    if (k > 0) motion.T_previous_current = truthAt(k - 1).inverse() * truthAt(k);
    motion.T_previous_current.translation().y() += sinks;
    Decision decision;
    decision.frame = k;
    if (k % 4 == 0) {
      decision.action = k < kLap ? Action::CreateExperience : Action::CloseLoop;
      here = k % kLap / 4;
    }
    decision.experience = here;
    MapUpdate update;
    REQUIRE(map.update(motion, decision, update).isOk());
    REQUIRE(firstInvalidField(update).empty());
  }
  std::vector<Eigen::Isometry3d> poses(static_cast<std::size_t>(laps * kLap + 1));
  for (std::size_t k = 0; k < poses.size(); ++k) {
    REQUIRE(map.poseOf(static_cast<std::int64_t>(k), poses[k]).isOk());
  }
  return poses;
}

double worstHeight(const std::vector<Eigen::Isometry3d>& poses) {
  double worst = 0;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const double off = poses[k].translation().y() - truthAt(static_cast<int>(k)).translation().y();
    worst = std::max(worst, std::abs(off));
  }
  return worst;
}

}  // namespace

TEST_CASE("without drift a hill has its height, in every lap") {
  CHECK(worstHeight(drive(true, 3, 0)) < 1e-6);
}

TEST_CASE("a height that odometry loses lap by lap is closed by loops") {
  const auto poses = drive(true, 3, 0.05);  // 2 m a lap
  CHECK(worstHeight(poses) < 1);            // odometry alone: 6 m
  CHECK(std::abs(poses.back().translation().y()) < 0.3);
}

TEST_CASE("without the parameter the map is planar") {
  for (const Eigen::Isometry3d& pose : drive(false, 2, 0.05)) CHECK(pose.translation().y() == 0);
}

TEST_CASE("links of the graph tell the climb between experiences") {
  test::TestContext services({{"height", true}});
  RelaxationMap map;
  REQUIRE(map.configure(services).isOk());
  for (int k = 0; k < 2; ++k) {
    Motion motion;
    motion.frame = k;
    if (k > 0) motion.T_previous_current.translation() << 0, -1.5, 4;
    Decision decision;
    decision.frame = k;
    decision.action = Action::CreateExperience;
    decision.experience = k;
    MapUpdate update;
    REQUIRE(map.update(motion, decision, update).isOk());
  }
  MapGraph graph;
  REQUIRE(map.graph(graph).isOk());
  REQUIRE(graph.links.size() == 1);
  CHECK(graph.links[0].T_from_to.translation().y() == Approx(-1.5));
  CHECK(graph.experiences[1].T_world_experience.translation().z() == Approx(4));
}
