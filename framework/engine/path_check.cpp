// SPDX-License-Identifier: BSD-3-Clause
#include "engine/path_check.hpp"

#include <fmt/format.h>

namespace tolman::pipeline {

void PathCheck::add(const Motion& motion) {
  if (motion.state != TrackingState::Tracking) return;
  steps_.push_back({motion.frame, motion.T_previous_current.translation().norm()});
}

std::optional<std::string> PathCheck::contradiction(std::span<const FramePose> poses) const {
  // Chosen, not tuned. Rejected loops moved single frames of legal maps by 13 m, and their paths
  // by less than a tenth.
  constexpr double kLonger = 2;
  constexpr double kAllowed = 1;  // m; a robot that stands has a path of noise
  double of_map = 0, of_odometry = 0;
  auto step = steps_.begin();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    while (step != steps_.end() && step->frame < poses[i].frame) ++step;
    if (step == steps_.end()) break;
    if (step->frame != poses[i].frame || poses[i - 1].frame != poses[i].frame - 1) continue;
    of_odometry += step->length;
    of_map +=
        (poses[i].T_world_camera.translation() - poses[i - 1].T_world_camera.translation()).norm();
  }
  if (of_map <= kLonger * of_odometry + kAllowed) return std::nullopt;
  return fmt::format(
      "the final poses of the tracked frames make a path of {:.4g} m, and odometry {:.4g} m: "
      "poseOf() moves frames apart that follow each other; trajectory and errors are of its poses",
      of_map, of_odometry);
}

}  // namespace tolman::pipeline
