// SPDX-License-Identifier: BSD-3-Clause
// Errors, counts and timing of a run, and their JSON: metrics.json.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/cell_scoring.hpp"
#include "evaluation/loops.hpp"
#include "evaluation/score.hpp"
#include "evaluation/truth_sensor.hpp"
#include "tolman/records.hpp"

namespace tolman::evaluation {

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

struct Metrics {
  Alignment alignment = Alignment::Se3;
  TrajectoryMetrics odometry;
  TrajectoryMetrics map;
  MotionConsistency motions;
  std::int64_t frames = 0;
  std::int64_t templates = 0;
  MapCounts counts;
  std::optional<LoopFigures> loops;  ///< none without truth
  std::optional<Extrinsic> body;     ///< of the truth, if `evaluation.body: estimate` found it
  std::string truth_sha256;          ///< of the true poses; empty without truth
  std::map<std::string, StageTiming> timing;
  std::int64_t parts = 0;  ///< connected parts of the map
  std::vector<SessionFigures> sessions;
  std::optional<CellFigures> cells;  ///< none where no activity was recorded
  std::string no_cells;  ///< why there are none although arrays were recorded; mostly empty
};

/// A sentence about the connected parts of the map; empty where there is only one.
std::string unjoinedText(const Metrics& metrics);

MapCounts countsOf(const MapGraph& graph, std::int64_t loop_decisions);

StageTiming stageTiming(const std::vector<std::int64_t>& durations_ns);

/// Unknown numbers are null, with the cause in `reason`. Top-level `coverage` is the smaller of the
/// two.
nlohmann::ordered_json toJson(const Metrics& metrics);
nlohmann::ordered_json toJson(const StageTiming& timing);

}  // namespace tolman::evaluation
