// SPDX-License-Identifier: BSD-3-Clause
// Fastest routes through an experience map: Dijkstra's algorithm over the travel times of the links
// (D. Ball et al., "OpenRatSLAM", Autonomous Robots 34, 2013, section on planning).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::planning {

struct Leg {
  std::int64_t experience = -1;
  double seconds = 0;  ///< travel time from the start
  double metres = 0;   ///< length from the start
};

struct PlannedRoute {
  std::vector<Leg> legs;  ///< from start to goal, both included
  double seconds() const { return legs.empty() ? 0 : legs.back().seconds; }
  double metres() const { return legs.empty() ? 0 : legs.back().metres; }
};

/// Links lead in both directions; those that the map has rejected are not used. A loop link has no
/// travel time of its own: it costs its length at the mean speed of the map. InvalidInput for
/// experiences that do not exist, and where no route connects them.
Result<PlannedRoute> fastestRoute(const MapGraph& graph, std::int64_t from, std::int64_t to);

/// Right, forward and upwards of the start, m.
Eigen::Vector3d placeOf(const Experience& experience);

/// The experience nearest to a place; -1 for an empty map. Without a height (NaN), the nearest in
/// the plane.
std::int64_t nearestExperience(const MapGraph& graph, const Eigen::Vector3d& place);

}  // namespace tolman::planning
