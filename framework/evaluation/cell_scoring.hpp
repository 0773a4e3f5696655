// SPDX-License-Identifier: BSD-3-Clause
// Scores the recorded cells of a run: errors of rings and grid modules against the truth, and the
// firing of their units: `cells` of metrics.json. Any plugin that describes its arrays
// (ArrayDescriptions) is scored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/recorded_cells.hpp"
#include "evaluation/score.hpp"
#include "evaluation/unit_scores.hpp"

namespace tolman::evaluation {

/// A population of head direction cells.
struct RingFigures {
  std::string array;
  std::size_t units = 0;
  std::optional<ErrorFigures> error_deg;  ///< of the population vector against the true heading
  RingScores scores;
};

/// A population of grid cells: one module.
struct SheetFigures {
  std::string array;
  std::size_t units = 0;
  double period = 0;
  std::string unit;  ///< of the period
  SheetScores scores;
};

struct CellFigures {
  bool truth =
      false;  ///< units are scored at the true places and headings; else at those of the map
  std::string reason;      ///< why there are no errors
  std::uint64_t seed = 1;  ///< of the shuffles
  std::size_t shuffles = 0;
  double least_shift_s = 0;
  std::vector<RingFigures> rings;
  std::vector<SheetFigures> sheets;
  std::optional<ErrorFigures> position_m;  ///< of the position that all modules decode
  double modulo_m = 0;          ///< a single module gives positions modulo this; 0: several modules
  std::string position_reason;  ///< why the modules give no position
};

/// Unknown numbers are null, with the cause in `reason`.
nlohmann::ordered_json toJson(const CellFigures& cells);

/// None without rings and sheets. `truth` is in the coordinates of the map, and `scored` has the
/// errors of the map. Units are measured at the true places, or without scores at those of the map.
/// `since_start` is the map with the earlier sessions: the code of grid modules has its origin at
/// its first frame, because cells go on from session to session.
std::optional<CellFigures> scoreCells(const CellHistory& cells, const Trajectory& map,
                                      const Trajectory& since_start, const Trajectory& truth,
                                      const TrajectoryMetrics& scored, std::uint64_t seed);

}  // namespace tolman::evaluation
