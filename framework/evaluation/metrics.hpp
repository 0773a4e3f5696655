// SPDX-License-Identifier: BSD-3-Clause
// Errors, counts and timing of a run, and their JSON: metrics.json.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/alignment.hpp"
#include "evaluation/cell_figures.hpp"
#include "evaluation/errors.hpp"
#include "evaluation/kitti_segments.hpp"
#include "evaluation/loop_figures.hpp"
#include "evaluation/motion_consistency.hpp"
#include "tolman/records.hpp"

namespace tolman::evaluation {

/// Errors of a trajectory against ground truth.
struct Scores {
  Statistics ate_m;         ///< absolute trajectory error; with Alignment::Se2 the horizontal part
  Statistics horizontal_m;  ///< horizontal part of ate_m; count 0: not known
  Statistics vertical_m;    ///< vertical part; count 0: not known
  std::string no_horizontal;  ///< why the horizontal part is not known
  std::string no_vertical;
  RelativeError rpe_frame;  ///< over one frame
  RelativeError rpe_metre;  ///< per metre, over steps of 1 m
  SegmentErrors kitti;
  double scale = 1;  ///< scale factor of the alignment
  double coverage = 0;
};

struct TrajectoryMetrics {
  double path_length_m = 0;  ///< of the aligned estimate; without scores in its own units
  bool in_metres = true;     ///< false: a single camera, and no truth that determines the scale
  std::size_t poses = 0;
  std::size_t matched = 0;
  std::optional<Scores> scores;
  std::string reason;   ///< why there are no scores
  std::string warning;  ///< why the scores may be misleading (axesHint()); mostly empty
};

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
  std::string truth_sha256;          ///< of the true poses; empty without truth
  std::map<std::string, StageTiming> timing;
  std::int64_t parts = 0;  ///< connected parts of the map
  std::vector<SessionFigures> sessions;
  std::optional<CellFigures> cells;  ///< none where no activity was recorded
  std::string no_cells;  ///< why there are none although arrays were recorded; mostly empty
};

/// A sentence about the connected parts of the map; empty where there is only one.
std::string unjoinedText(const Metrics& metrics);

/// Scores an estimate; an empty truth or estimate gives a reason instead of scores. Drift is over
/// `lengths`, by default lengthsFor(). `max_difference_ns` < 0 matches by frame index, else by
/// nearest stamp.
TrajectoryMetrics scoreTrajectory(const Trajectory& truth, const Trajectory& estimate,
                                  Alignment alignment,
                                  const std::optional<SegmentLengths>& lengths = std::nullopt,
                                  std::int64_t max_difference_ns = -1);

MapCounts countsOf(const MapGraph& graph, std::int64_t loop_decisions);

StageTiming stageTiming(const std::vector<std::int64_t>& durations_ns);

/// `odometry` and `map` have the same keys; unknown numbers are null, with the cause in `reason`.
/// Top-level `coverage` is the smaller of the two.
nlohmann::ordered_json toJson(const Metrics& metrics);
nlohmann::ordered_json toJson(const TrajectoryMetrics& metrics);
nlohmann::ordered_json toJson(const StageTiming& timing);

}  // namespace tolman::evaluation
