// SPDX-License-Identifier: BSD-3-Clause
// Scores the recorded cells of a run: errors of rings and grid modules against the truth, and the
// firing of their units. Any plugin that describes its arrays (ArrayDescriptions) is scored.
#pragma once

#include <cstdint>
#include <optional>

#include "evaluation/metrics.hpp"
#include "evaluation/recorded_cells.hpp"

namespace tolman::evaluation {

/// None without rings and sheets. `truth` is in the coordinates of the map, and `scored` has the
/// errors of the map. Units are measured at the true places, or without scores at those of the map.
/// `since_start` is the map with the earlier sessions: the code of grid modules has its origin at
/// its first frame, because cells go on from session to session.
std::optional<CellFigures> scoreCells(const CellHistory& cells, const Trajectory& map,
                                      const Trajectory& since_start, const Trajectory& truth,
                                      const TrajectoryMetrics& scored, std::uint64_t seed);

}  // namespace tolman::evaluation
