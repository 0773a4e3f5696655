// SPDX-License-Identifier: BSD-3-Clause
// Scores an estimate against the truth, and the JSON of its figures. Doubts about what is scored
// stand beside them.
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
  Matches pairs;                     ///< with the estimate aligned
  double scale = 1;                  ///< scale factor of the alignment
  double coverage = 0;
};

/// Of each pair, m; with Alignment::Se2 in the plane.
std::vector<double> positionErrors(const Scores& scores);

struct TrajectoryMetrics {
  double path_length_m = 0;  ///< of the aligned estimate; without scores in its own units
  bool in_metres = true;     ///< false: a single camera, and no truth that determines the scale
  std::size_t poses = 0;
  std::size_t matched = 0;
  std::optional<Scores> scores;
  std::string reason;   ///< why there are no scores
  std::string warning;  ///< doubtText(), set by the caller
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
  bool whole_segments = false;    ///< drift from every 10th true pose, as in segmentErrors()
  bool single_precision = false;  ///< of that drift
  std::vector<Steps> steps;       ///< of further relative errors
  bool without_time = false;      ///< also distances between the paths
};

/// Whose habits. Their definitions are those of docs/evaluation.md.
enum class Habit : std::uint8_t { Tolman, Evo, Kitti, Devkit, Tum, Rpg };
inline constexpr std::array<std::string_view, 6> kHabitNames = {"tolman", "evo", "kitti",
                                                                "devkit", "tum", "rpg"};
constexpr std::span<const std::string_view> enumNames(Habit) { return kHabitNames; }
/// KITTI's programs take matrices as they are written, exact rotations or not.
constexpr bool readsMatrices(Habit habit) {
  return habit == Habit::Kitti || habit == Habit::Devkit;
}
/// "10 m, consecutive".
std::string textOf(const Steps& steps);
/// `steps` have lengths and units, the habit sets the rest; of `all` where it leaves no choice.
Protocol protocolOf(Habit habit, const Trajectory& truth, const Trajectory& estimate,
                    std::vector<Steps> steps = {});

/// Scores an estimate; an empty truth or estimate gives a reason instead of scores.
TrajectoryMetrics score(const Trajectory& truth, const Trajectory& estimate,
                        const Protocol& protocol);

/// What speaks against a truth or an estimate: is one of the two read wrongly, or broken somewhere
/// (step_series.hpp)? One sentence each: what was found, and what to look for. Doubts change no
/// score. Empty for plausible trajectories, whatever the errors of the estimate.
std::vector<std::string> doubts(const Trajectory& truth, const Trajectory& estimate,
                                const Protocol& protocol);
/// All doubts in one text; empty without any.
std::string doubtText(const std::vector<std::string>& doubts);

/// Of `odometry` and of `map` in metrics.json; unknown numbers are null, with a `reason`.
nlohmann::ordered_json toJson(const TrajectoryMetrics& metrics);
/// The figures that only `eval` gives: rotation, steps, table of segments, path.
nlohmann::ordered_json detailsJson(const Scores& scores, const std::vector<Steps>& steps);

}  // namespace tolman::evaluation
