// SPDX-License-Identifier: BSD-3-Clause
// Scores the recorded cells of a run: errors of rings and grid modules against the truth, and the
// firing of their units: `cells` of metrics.json. Any plugin that describes its arrays
// (ArrayDescriptions) is scored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/localisation.hpp"
#include "evaluation/loops.hpp"
#include "evaluation/recorded_cells.hpp"
#include "evaluation/score.hpp"
#include "evaluation/step_series.hpp"
#include "tolman/records.hpp"

namespace tolman::evaluation {

/// A population of head direction cells, or one module of grid cells.
struct PopulationFigures {
  std::string array;
  std::size_t units = 0;
  PopulationScores scores;
  Statistics error_deg{};  ///< of a ring: population vector against true heading; count 0: unknown
  double period = 0;       ///< of a module
  std::string unit{};      ///< of the period
};

struct CellFigures {
  bool truth =
      false;  ///< units are scored at the true places and headings; else at those of the map
  std::string reason;      ///< why there are no errors
  std::uint64_t seed = 1;  ///< of the shuffles
  std::size_t shuffles = 0;
  double least_shift_s = 0;
  double speed_limit = 0;  ///< m/s; slower samples do not count in maps, curves and scores
  std::vector<PopulationFigures> rings;
  std::vector<PopulationFigures> sheets;
};

/// Unknown numbers are null, with the cause in `reason`.
nlohmann::ordered_json toJson(const CellFigures& cells);

/// None without rings and sheets. `truth` is in the coordinates of the map, and `scored` has the
/// errors of the map. Units are measured at the true places, or without scores at those of the map.
std::optional<CellFigures> scoreCells(const CellHistory& cells, const Trajectory& map,
                                      const Trajectory& truth, const TrajectoryMetrics& scored,
                                      std::uint64_t seed);

// Errors, counts and timing of a run, and their JSON: metrics.json.

/// Computing time of a stage per frame, ms.
struct StageTiming {
  std::size_t frames = 0;
  double mean_ms = 0;
  double median_ms = 0;
  double p90_ms = 0;
  double p95_ms = 0;
  double max_ms = 0;
};

/// Size of the finished map, and number of loops that the cells decided. The two numbers of loops
/// differ: a map may merge decisions of one visit into one link, and it may reject links.
struct MapCounts {
  std::int64_t experiences = 0;
  std::int64_t links = 0;                ///< of both kinds, rejected ones left out
  std::int64_t loop_links = 0;           ///< those of `links` that close a loop
  std::int64_t rejected_loop_links = 0;  ///< not among `links`
  std::int64_t loop_decisions = 0;       ///< frames with the decision close_loop
};

/// The frames and experiences of one session, and their connected parts of the map.
struct SessionFigures {
  std::string name;
  std::int64_t first_frame = 0;
  std::int64_t frames = 0;
  std::int64_t experiences = 0;
  std::vector<std::int64_t> parts;  ///< parts of the map with its experiences
};

/// metrics.json. report/run_data.cpp: measure() fills it from the record.
struct Metrics {
  Alignment alignment = Alignment::Se3;
  TrajectoryMetrics odometry;
  TrajectoryMetrics map;
  MotionConsistency motions;
  std::int64_t frames = 0;
  std::int64_t templates = 0;
  MapCounts counts;
  std::optional<LoopFigures> loops;                 ///< none without truth
  std::optional<LocalisationFigures> localisation;  ///< of a run that localises in another's map
  std::optional<bool> returns;    ///< to an earlier place, by the truth; none without truth
  std::optional<Extrinsic> body;  ///< of the truth, if `evaluation.body: estimate` found it
  std::string truth_sha256;       ///< of the true poses; empty without truth
  std::map<std::string, StageTiming> timing;
  std::int64_t parts = 0;  ///< connected parts of the map
  std::vector<SessionFigures> sessions;
  std::optional<CellFigures> cells;  ///< none where no activity was recorded
};

/// What to know of a run before its numbers, most important first: false loops, a map worse than
/// its odometry, a camera that does not move, a recording that never returns to a place.
std::vector<std::string> verdictsOf(const Metrics& metrics);

/// "sim3, scale 1.234 fitted": figures after it do not compare with those of a known scale.
std::string alignmentText(const Metrics& metrics);

/// A sentence about the connected parts of the map; empty where there is only one.
std::string unjoinedText(const Metrics& metrics);

MapCounts countsOf(const MapGraph& graph, std::int64_t loop_decisions);

StageTiming stageTiming(const std::vector<std::int64_t>& durations_ns);

/// Unknown numbers are null, with the cause in `reason`. `coverage` is the smaller of the two.
nlohmann::ordered_json toJson(const Metrics& metrics);
nlohmann::ordered_json toJson(const StageTiming& timing);

}  // namespace tolman::evaluation
