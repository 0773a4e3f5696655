// SPDX-License-Identifier: BSD-3-Clause
// The figures of a run, and their JSON: metrics.json.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/alignment.hpp"
#include "evaluation/errors.hpp"
#include "evaluation/kitti_segments.hpp"

namespace tolman::evaluation {

/// What only the truth can tell of a trajectory.
struct Scores {
  Statistics ate_m;
  RelativeError rpe_frame;  ///< over one frame
  RelativeError rpe_metre;  ///< per metre, over steps of 1 m
  SegmentErrors kitti;
  double scale = 1;  ///< that the alignment has applied to the estimate
  double coverage = 0;
};

struct TrajectoryMetrics {
  double path_length_m = 0;
  std::size_t poses = 0;
  std::size_t matched = 0;
  std::optional<Scores> scores;
  std::string reason;  ///< why there are no scores
};

/// Time that a stage took a frame, ms.
struct StageTiming {
  std::size_t frames = 0;
  double mean_ms = 0;
  double median_ms = 0;
  double p90_ms = 0;
  double p95_ms = 0;
  double max_ms = 0;
};

/// One session of the map's life, and how it hangs together with the others.
struct SessionFigures {
  std::string name;
  std::int64_t first_frame = 0;
  std::int64_t frames = 0;
  std::int64_t experiences = 0;
  std::vector<std::int64_t> parts;  ///< of the map that its experiences are in
};

struct Metrics {
  Alignment alignment = Alignment::Se3;
  TrajectoryMetrics odometry;
  TrajectoryMetrics map;
  std::int64_t frames = 0;
  std::int64_t templates = 0;
  std::int64_t experiences = 0;
  std::int64_t loops = 0;
  std::map<std::string, StageTiming> timing;
  std::int64_t parts = 0;  ///< of the map that no link joins
  std::vector<SessionFigures> sessions;
};

/// "sessions 0 and 2 are not joined", or nothing when the whole map hangs together.
std::string unjoinedText(const Metrics& metrics);

/// Scores an estimate; an empty truth or estimate gives a reason instead of scores. Drift is over
/// `lengths`, or as lengthsFor() says. `max_difference_ns` < 0 matches by frame index, else by
/// nearest stamp.
TrajectoryMetrics scoreTrajectory(const Trajectory& truth, const Trajectory& estimate,
                                  Alignment alignment,
                                  const std::optional<SegmentLengths>& lengths = std::nullopt,
                                  std::int64_t max_difference_ns = -1);

StageTiming stageTiming(const std::vector<std::int64_t>& durations_ns);

/// `odometry` and `map` have the same keys; figures that are not known are null, and `reason`
/// says why. Top-level `coverage` is the smaller of the two.
nlohmann::ordered_json toJson(const Metrics& metrics);
nlohmann::ordered_json toJson(const TrajectoryMetrics& metrics);
nlohmann::ordered_json toJson(const StageTiming& timing);

}  // namespace tolman::evaluation
