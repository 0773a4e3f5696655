// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: a trajectory, KITTI or TUM, as `tolman eval` reads it. Accepted ones are scored
// against a straight drive and against themselves; every error is finite.
#include "evaluation/trajectory.hpp"

#include "evaluation/metrics.hpp"
#include "evaluation/score.hpp"
#include "input.hpp"

namespace {

using namespace tolman::evaluation;

Trajectory straight(std::size_t poses) {
  Trajectory trajectory(poses);
  for (std::size_t i = 0; i < poses; ++i) {
    trajectory[i].frame = static_cast<std::int64_t>(i);
    trajectory[i].stamp_ns = static_cast<std::int64_t>(i) * 100'000'000;
    trajectory[i].T_world_camera.translation().z() = static_cast<double>(i);
  }
  return trajectory;
}

void scoreAll(const Trajectory& truth, const Trajectory& estimate) {
  for (const Alignment alignment :
       {Alignment::Se3, Alignment::Se2, Alignment::Sim3, Alignment::None}) {
    for (const MatchRule by : {MatchRule::Order, MatchRule::Nearest, MatchRule::Interpolate}) {
      const Protocol protocol(alignment, std::nullopt, {by, 50'000'000});
      const TrajectoryMetrics metrics = score(truth, estimate, protocol);
      doubts(truth, estimate, protocol);
      tolman::fuzz::require(std::isfinite(metrics.path_length_m), "a length that is not finite");
      if (!metrics.scores) continue;
      tolman::fuzz::require(std::isfinite(metrics.scores->ate_m.rmse), "an ATE that is not finite");
      tolman::fuzz::require(std::isfinite(metrics.scores->scale), "a scale that is not finite");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const tolman::fuzz::MemoryFile file({data, size});
  const auto read = readTrajectory(file.path());
  if (!read.isOk()) {
    tolman::fuzz::require(!read.status().message().empty(), "refused without a message");
    return 0;
  }
  for (const TrajectoryPose& pose : read.value()) {
    tolman::fuzz::require(pose.T_world_camera.matrix().allFinite(), "a pose that is not finite");
  }
  scoreAll(straight(read.value().size()), read.value());
  scoreAll(read.value(), read.value());
  return 0;
}
