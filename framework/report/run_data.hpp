// SPDX-License-Identifier: BSD-3-Clause
// The data behind metrics, figures and page of a run, read once from its record. Why its loops were
// closed, rejected or missed: what place recognition, cells and map recorded of each of them, as
// numbers beside their limits and as a paragraph.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "config/settings.hpp"
#include "evaluation/metrics.hpp"
#include "evaluation/recorded_cells.hpp"
#include "evaluation/step_series.hpp"
#include "evaluation/trajectory.hpp"
#include "record/run_reader.hpp"

namespace tolman::report {

/// How far a loop came.
enum class Ending : std::uint8_t {
  Kept,        ///< a link of the map
  Rejected,    ///< a link that the map has rejected
  Undecided,   ///< the cells had a hypothesis, and did not accept it
  Unfamiliar,  ///< place recognition had a candidate, and did not answer with it
  Nothing,     ///< of a frame with none of these
};
inline constexpr std::array<std::string_view, 5> kEndingNames = {
    "kept", "rejected", "not accepted by the cells", "not recognised", "nothing to close"};
constexpr std::span<const std::string_view> enumNames(Ending) { return kEndingNames; }

/// One hypothesis of the cells, from its first view to its end.
struct HypothesisLife {
  std::int64_t id = -1;
  std::int64_t first_frame = -1;
  std::int64_t last_view_frame = -1;
  std::int64_t end_frame = -1;  ///< at which it was accepted or removed; -1: the run ended
  PlaceHypothesis best;         ///< at its largest share
  PlaceHypothesis end;          ///< its last change
};

struct LoopStory {
  Ending ending = Ending::Nothing;
  std::int64_t frame = -1;
  std::int64_t earlier = -1;  ///< the frame of the place that was or would be recognised
  Recognition recognition = Recognition::None;
  bool has_pose = false;  ///< whether the view has a measured pose
  std::optional<Candidate> candidate;
  std::optional<HypothesisLife> hypothesis;
  std::optional<evaluation::JudgedLoop> link;
  std::string unit = "m";

  /// The story in plain English, with each number beside its limit.
  std::string text() const;
  /// The same in a few words, for tables: score, share, residual, and whether it is true.
  std::vector<std::string> cells() const;
  nlohmann::ordered_json json() const;
};

/// Headings of LoopStory::cells().
std::vector<std::string> storyHeadings();

/// What is read once for the stories of a run.
struct LoopRecord {
  std::vector<PlaceObservation> places;
  std::vector<Decision> decisions;
  std::vector<evaluation::JudgedLoop> loops;
  evaluation::Trajectory odometry;
  bool in_metres = true;
};
/// Failures are thrown (base/must.hpp).
LoopRecord readLoops(const record::RunReader& reader, const evaluation::Trajectory& truth,
                     double storey_height);

/// Loops and near misses: links that are kept, the least certain last; links that are rejected;
/// hypotheses that were not accepted, and candidates that were not recognised, nearest to their
/// limits first. Of candidates near each other one, and none on the path just driven.
std::vector<LoopStory> storiesOf(const LoopRecord& record);

/// The story of a frame; none where the run has no such frame.
std::optional<LoopStory> storyOf(const LoopRecord& record, std::int64_t frame);

/// Two views beside each other under their frame numbers, as SVG; empty where one is missing.
std::string pairFigure(const LoopStory& story, const Image& earlier, const Image& now);

/// Position error at each frame with truth, and motions over short stretches against true ones.
struct ErrorSeries {
  std::vector<double> seconds;  ///< data time since the first frame of the run
  std::vector<double> metres;
  evaluation::StepSeries steps{};
};

struct RunData {
  std::string name;
  evaluation::Trajectory truth;  ///< aligned with the map, in the world frame and unit of the run
  evaluation::Trajectory odometry;
  evaluation::Trajectory map;
  ErrorSeries odometry_error;
  ErrorSeries map_error;
  MapGraph graph;
  evaluation::Metrics metrics;
  evaluation::CellHistory cells;
  LoopRecord record;             ///< all answers of places and cells
  std::vector<LoopStory> loops;  ///< and near misses
  double metres = 1;       ///< metres per unit of the run; other than 1 only with Alignment::Sim3
  bool has_metres = true;  ///< false: the scale is unknown, and there is no truth to determine it

  /// The trajectory at which the activity of the cells is measured.
  const evaluation::Trajectory& places() const { return metrics.map.scores ? truth : map; }
};

/// The loops of a run, without its other figures.
Result<LoopRecord> readLoops(const record::RunReader& reader,
                             const config::EvaluationSettings& settings);

/// InvalidInput if the record is damaged or empty. `seed`: of the run, for the scores by chance.
Result<RunData> readRun(const record::RunReader& reader, const config::EvaluationSettings& settings,
                        std::uint64_t seed = 1);

}  // namespace tolman::report
