// SPDX-License-Identifier: BSD-3-Clause
#include "engine/localised_map.hpp"

#include <algorithm>
#include <utility>

namespace tolman::engine {

LocalisedMap::LocalisedMap(MapGraph graph, std::int64_t first_frame)
    : graph_(std::move(graph)), first_frame_(first_frame) {
  last_.version = graph_.version;
  last_.experiences = std::ssize(graph_.experiences);
  last_.links = std::ssize(graph_.links);
  last_.loops = std::ranges::count(graph_.links, LinkKind::Loop, &Link::kind);
}

MapUpdate LocalisedMap::update(const Motion& motion, const Decision& decision) {
  last_.frame = motion.frame;
  last_.stamp_ns = motion.stamp_ns;
  last_.experience = decision.has_relative_pose ? decision.experience : -1;
  if (last_.experience >= 0) {
    const auto at = static_cast<std::size_t>(last_.experience);
    last_.T_experience_camera = decision.T_experience_current;
    last_.T_world_camera =
        graph_.experiences[at].T_world_experience * decision.T_experience_current;
  } else {
    last_.T_experience_camera.setIdentity();
    last_.T_world_camera = normalised(last_.T_world_camera * motion.T_previous_current);
  }
  return last_;
}

}  // namespace tolman::engine
