// SPDX-License-Identifier: BSD-3-Clause
// Scores the recorded cells of a run: what rings and grid modules say against the truth, and how
// their units fire. Any plugin that describes its arrays (ArrayDescriptions) is scored.
#pragma once

#include <cstdint>
#include <optional>

#include "evaluation/metrics.hpp"
#include "evaluation/recorded_cells.hpp"

namespace tolman::evaluation {

/// None without rings and sheets. `truth` is in the frame of the map, whose errors are `scored`;
/// units are measured at its places, without scores at those of the map.
std::optional<CellFigures> scoreCells(const CellHistory& cells, const Trajectory& map,
                                      const Trajectory& truth, const TrajectoryMetrics& scored,
                                      std::uint64_t seed);

}  // namespace tolman::evaluation
