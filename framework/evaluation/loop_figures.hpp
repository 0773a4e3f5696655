// SPDX-License-Identifier: BSD-3-Clause
// Loop links and recognised views, judged by the true places of both ends.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "evaluation/trajectory.hpp"
#include "tolman/records.hpp"

namespace tolman::evaluation {

/// Links and views are true or false if both ends have a true pose. Others are unknown: in a
/// continued run, for example, true poses of the earlier session are those of another world.
struct LoopFigures {
  std::int64_t true_links = 0;   ///< loop links of the final graph between ends at most 10 m apart
  std::int64_t false_links = 0;  ///< those between ends that are further apart
  std::int64_t true_views = 0;   ///< familiar views, at most 10 m from where the view was learned
  std::int64_t false_views = 0;
  std::int64_t unknown_links = 0;  ///< loop links of the final graph
  std::int64_t unknown_views = 0;  ///< familiar views
  /// Number of true views with the end of a true loop link (rejected or not) at most 5.5 m of
  /// driven path away: one loop spacing and half a metre.
  std::int64_t true_views_closed = 0;
};

/// Places that are more than `storey_height` metres apart in height (y of the true poses) are
/// different ones; 0: heights are ignored.
LoopFigures loopFigures(const MapGraph& graph, const std::vector<PlaceObservation>& places,
                        const Trajectory& truth, double storey_height = 0);

nlohmann::ordered_json toJson(const LoopFigures& figures);

}  // namespace tolman::evaluation
