// SPDX-License-Identifier: BSD-3-Clause
// Scores an estimate against the truth, and the JSON of its figures. Doubts about what is scored
// stand beside them (plausibility.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evaluation/association.hpp"
#include "evaluation/errors.hpp"

namespace tolman::evaluation {

// Which part of a position error is vertical: y of the first true camera is down, if its axes are
// those of a camera, and if the alignment determines the roll of the estimate.

/// A sentence if the poses move along their own x axis and more along the y than along the z axis
/// of the first pose, as poses with x forward and z up do. Else empty.
std::string upAxisProblem(const Trajectory& truth);

/// Why the x-z plane of the first pose cannot be that of the drive; empty if it can.
std::string planeProblem(const Trajectory& truth);

/// On an almost straight path positions do not determine the roll, so horizontal and vertical
/// errors may be swapped: a quarter turn about a principal direction of the truth increases the
/// root mean square error by less than 5 %, and turns about it move more than a tenth of the
/// squared error between the two.
bool rollIsUnobservable(const Matches& aligned);

/// The orientations of the estimate contradict the alignment, and its positions do not refute them:
/// a turn of the estimate about its mean position tilts the vertical (y) by more than 10 degrees,
/// and after it the root mean square error is at most three times as large, or below 1 % of the
/// true path. The turn is the one that brings the estimated orientations nearest to the true ones,
/// or its part about a principal direction of the truth.
bool rollIsContradicted(const Matches& aligned);

/// Errors of a trajectory against ground truth.
struct Scores {
  AlignmentRule alignment;
  Statistics ate_m;         ///< absolute trajectory error; with Alignment::Se2 the horizontal part
  Statistics horizontal_m;  ///< horizontal part of ate_m; count 0: not known
  Statistics vertical_m;    ///< vertical part; count 0: not known
  std::string no_horizontal;  ///< why the horizontal part is not known
  std::string no_vertical;
  RelativeError rpe_frame;  ///< over one frame
  RelativeError rpe_metre;  ///< per metre, over steps of 1 m
  SegmentErrors kitti;
  Statistics rotation_deg;           ///< angles between true and estimated orientations
  std::vector<RelativeError> steps;  ///< of Protocol::steps
  std::optional<PathDistance> path;  ///< if asked for
  std::vector<double> errors_m;      ///< of each matched pose
  std::vector<double> driven_m;      ///< the true path up to it
  double scale = 1;                  ///< scale factor of the alignment
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

/// Whether the truth has one orientation throughout while the estimate turns by more than noise.
bool hasPositionsAlone(const Matches& pairs);

/// How an estimate is scored. Every tool has its own habits; those of others are in protocolOf().
struct Protocol {
  Protocol() = default;
  Protocol(Alignment kind, std::optional<SegmentLengths> of = std::nullopt, Matching by = {})
      : matching(by), alignment{kind}, lengths(std::move(of)) {}

  Matching matching;  ///< by default frame N with frame N
  AlignmentRule alignment;
  std::optional<SegmentLengths> lengths;  ///< of drift; none: lengthsFor() the path
  bool whole_segments = false;  ///< drift from every 10th true pose, as in segmentErrors()
  std::vector<Steps> steps;     ///< of further relative errors
  bool without_time = false;    ///< also distances between the paths
};

/// Whose habits. Their definitions are those of docs/evaluation.md.
enum class Habit : std::uint8_t { Tolman, Evo, Kitti, Tum, Rpg };
inline constexpr std::array<std::string_view, 5> kHabitNames = {"tolman", "evo", "kitti", "tum",
                                                                "rpg"};
constexpr std::span<const std::string_view> enumNames(Habit) { return kHabitNames; }
/// "10 m, consecutive".
std::string textOf(const Steps& steps);
/// For files with or without stamps. `steps` have lengths and units, the habit sets the rest; of
/// `all` only where it leaves the choice.
Protocol protocolOf(Habit habit, const Trajectory& truth, const Trajectory& estimate,
                    std::vector<Steps> steps = {});

/// Scores an estimate; an empty truth or estimate gives a reason instead of scores.
TrajectoryMetrics score(const Trajectory& truth, const Trajectory& estimate,
                        const Protocol& protocol);

/// `odometry` and `map` of metrics.json have the same keys; unknown numbers are null, with the
/// cause in `reason`.
nlohmann::ordered_json toJson(const TrajectoryMetrics& metrics);
/// The figures that only `eval` gives: rotation, steps, table of segments, path.
nlohmann::ordered_json detailsJson(const Scores& scores, const std::vector<Steps>& steps);

}  // namespace tolman::evaluation
