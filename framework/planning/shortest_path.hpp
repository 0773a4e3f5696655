// SPDX-License-Identifier: BSD-3-Clause
// Ways through an experience map, as a rat would take them: the fastest, by the times that its
// links took to travel (D. Ball et al., "OpenRatSLAM", Autonomous Robots 34, 2013, section on
// planning).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::planning {

struct Leg {
  std::int64_t experience = -1;
  double seconds = 0;  ///< from the start
  double metres = 0;
};

struct Route {
  std::vector<Leg> legs;  ///< from start to goal, both included
  double seconds() const { return legs.empty() ? 0 : legs.back().seconds; }
  double metres() const { return legs.empty() ? 0 : legs.back().metres; }
};

/// The fastest way (Dijkstra). Links can be travelled both ways. A loop link took no time; it costs
/// its length at the mean speed of the map. InvalidInput for experiences that do not exist, and
/// where no way leads there.
Result<Route> fastestRoute(const MapGraph& graph, std::int64_t from, std::int64_t to);

/// The experience nearest to a place of the plane (right, forward), m; -1 for an empty map.
std::int64_t nearestExperience(const MapGraph& graph, const Eigen::Vector2d& place);

}  // namespace tolman::planning
