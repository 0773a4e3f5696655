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
  std::vector<Leg> legs;    ///< from start to goal, both included
  bool times_known = true;  ///< false: no link has a duration, and seconds are those at 1 m/s
  double seconds() const { return legs.empty() ? 0 : legs.back().seconds; }
  double metres() const { return legs.empty() ? 0 : legs.back().metres; }
};

/// Links are used in both directions; rejected links are not used. A loop link has no travel time
/// of its own: its time, and that of an odometry link of duration 0, is its length divided by the
/// mean speed of the links with a duration. InvalidInput for experiences that do not exist or are
/// not connected.
Result<PlannedRoute> fastestRoute(const MapGraph& graph, std::int64_t from, std::int64_t to);

/// The map without the experiences that cannot be reached from `here`; the whole map for -1.
MapGraph connectedTo(MapGraph graph, std::int64_t here);

/// Position relative to the start: right, forward and up, m.
Eigen::Vector3d placeOf(const Experience& experience);

/// The experience nearest to a place (right, forward, up, m); -1 for an empty map. If the height is
/// NaN, the nearest in the plane.
std::int64_t nearestExperience(const MapGraph& graph, const Eigen::Vector3d& place);

}  // namespace tolman::planning
