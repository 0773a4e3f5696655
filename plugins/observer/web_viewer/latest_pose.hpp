// SPDX-License-Identifier: BSD-3-Clause
// The newest pose of the robot, for other programs (/api/pose and /api/events).
#pragma once

#include <algorithm>

#include "tolman/roles.hpp"

namespace tolman::web_viewer {

struct LatestPose {
  std::int64_t frame = -1;  ///< -1: none yet
  std::int64_t stamp_ns = 0;
  TrackingState state = TrackingState::Initialising;
  bool scale_known = true;
  std::int64_t experience = -1;
  Eigen::Isometry3d T_experience_camera = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();

  void assign(const Snapshot& snapshot) {
    if (snapshot.map == nullptr || snapshot.motion == nullptr) return;
    frame = snapshot.frame->frame;
    stamp_ns = snapshot.frame->stamp_ns;
    state = snapshot.motion->state;
    scale_known = snapshot.motion->scale_known;
    experience = snapshot.map->experience;
    T_experience_camera = snapshot.map->T_experience_camera;
    T_world_camera = snapshot.map->T_world_camera;
  }

  /// Places the pose in the final graph, which a map optimises once more after the last frame: as
  /// the page does with all frames, it stays where it was seen from its experience.
  void assignFinal(const MapGraph& graph) {
    const auto found = std::ranges::find(graph.experiences, experience, &Experience::id);
    if (frame < 0 || found == graph.experiences.end()) return;
    T_world_camera = found->T_world_experience * T_experience_camera;
  }
};

}  // namespace tolman::web_viewer
