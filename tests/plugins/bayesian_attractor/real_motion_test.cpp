// SPDX-License-Identifier: BSD-3-Clause
// Decisions of the network on real loop candidates of real KITTI motion.
#include <catch2/catch.hpp>
#include <map>

#include "bump_network.hpp"
#include "recorded_drive.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

struct Counts {
  int right = 0;
  int wrong = 0;
};

/// Candidates whose bumps are accepted; candidate (i, j): frame i looks like frame j. Odometry
/// turns by `bias` (rad/m) too far.
Counts closedBy(const std::filesystem::path& folder, const NetworkSettings& settings,
                double bias = 0) {
  const auto motion = readEdges(folder / "odometry.g2o");
  const auto truth = posesOf(readEdges(folder / "ground_truth.g2o"));
  std::multimap<int, Edge> candidates;
  for (const Edge& edge : readEdges(folder / "loop_candidates.g2o")) {
    candidates.emplace(edge.from, edge);
  }
  const Eigen::Matrix3d measured = Eigen::Vector3d(0.09, 0.09, 9e-4).asDiagonal();
  BumpNetwork network(settings);
  std::vector<LearnedPattern> learned = {network.currentPattern()};
  Counts counts;
  for (int frame = 1; frame <= static_cast<int>(motion.size()); ++frame) {
    PlanarPose step = motion[static_cast<std::size_t>(frame - 1)].step;
    const double length = std::hypot(step.x, step.y);
    step.theta += bias * length;
    const double along = 0.02 * length + 1e-3;
    network.integrate(
        step, Eigen::Vector3d(along * along, along * along, 4e-6 * length + 1e-8).asDiagonal());
    const auto [first, last] = candidates.equal_range(frame);
    for (auto it = first; it != last; ++it) {
      const auto then = static_cast<std::size_t>(it->second.to);
      const PlanarPose offset = between(it->second.step, {});
      const Recalibration calibrated = network.inject(learned[then], offset, measured);
      if (!calibrated.accepted) continue;
      for (LearnedPattern& pattern : learned) network.follow(calibrated, pattern);
      const PlanarPose apart = between(truth[static_cast<std::size_t>(frame)], truth[then]);
      int& count = std::hypot(apart.x, apart.y) <= 10 ? counts.right : counts.wrong;
      count += static_cast<int>(calibrated.views);
    }
    learned.push_back(network.currentPattern());
  }
  return counts;
}

struct Expected {
  const char* sequence;
  int right;  ///< candidates that are true, by true_loops.txt
};

}  // namespace

TEST_CASE("KITTI candidates, 70-99 % false: the network closes the true ones and no other",
          "[data]") {
  const Expected expected = GENERATE(Expected{"00", 117}, Expected{"02", 34}, Expected{"05", 62},
                                     Expected{"06", 45}, Expected{"07", 1});
  const auto folder = tolman::test::dataOrSkip(std::string("kitti_motion/") + expected.sequence);
  if (!folder) return;
  const Counts counts = closedBy(*folder, {});
  INFO("KITTI " << expected.sequence << ": true/false candidates closed " << counts.right << "/"
                << counts.wrong << " of " << expected.right);
  CHECK(counts.wrong == 0);
  CHECK(counts.right >= static_cast<int>(std::floor(0.98 * expected.right)));
  CHECK(closedBy(*folder, {.injection = 0}).right == 0);
}

TEST_CASE("loops are found although odometry turns so much too far that its path is a spiral",
          "[data]") {
  const Expected expected = GENERATE(Expected{"00", 117}, Expected{"06", 45});
  const double bias = GENERATE(0.002, -0.002);  // rad/m: 2.1 rad until the first loop of 00
  const auto folder = tolman::test::dataOrSkip(std::string("kitti_motion/") + expected.sequence);
  if (!folder) return;
  const Counts counts = closedBy(*folder, {}, bias);
  INFO("KITTI " << expected.sequence << ": " << counts.right << "/" << counts.wrong);
  CHECK(counts.wrong == 0);
  CHECK(counts.right >= static_cast<int>(std::floor(0.95 * expected.right)));
}

TEST_CASE("with one grid module distant places are alike, and false loops are closed", "[data]") {
  const auto folder = tolman::test::dataOrSkip("kitti_motion/00");
  if (!folder) return;
  const Counts counts = closedBy(*folder, {.modules = 1});
  CHECK(counts.wrong > 0);
}
