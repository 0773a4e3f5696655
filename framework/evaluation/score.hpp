// SPDX-License-Identifier: BSD-3-Clause
// Scores an estimate against the truth, and the JSON of its figures. Doubts about what is scored
// stand beside them (plausibility.hpp).
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "evaluation/alignment.hpp"
#include "evaluation/errors.hpp"

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
  std::string warning;  ///< doubtText() of plausibility.hpp, set by the caller
};

/// Scores an estimate; an empty truth or estimate gives a reason instead of scores. Drift is over
/// `lengths`, by default lengthsFor(). `max_difference_ns` < 0 matches by frame index, else by
/// nearest stamp.
TrajectoryMetrics score(const Trajectory& truth, const Trajectory& estimate, Alignment alignment,
                        const std::optional<SegmentLengths>& lengths = std::nullopt,
                        std::int64_t max_difference_ns = -1);

/// `odometry` and `map` of metrics.json have the same keys; unknown numbers are null, with the
/// cause in `reason`.
nlohmann::ordered_json toJson(const TrajectoryMetrics& metrics);

}  // namespace tolman::evaluation
