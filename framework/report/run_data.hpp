// SPDX-License-Identifier: BSD-3-Clause
// The data behind metrics, figures and page of a run, read once from its record.
#pragma once

#include <string>
#include <vector>

#include "config/settings.hpp"
#include "evaluation/metrics.hpp"
#include "evaluation/recorded_cells.hpp"
#include "evaluation/step_series.hpp"
#include "evaluation/trajectory.hpp"
#include "record/run_reader.hpp"
#include "report/loop_stories.hpp"

namespace tolman::report {

/// Position error at each frame with ground truth, and motions over short stretches against true
/// ones.
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
  std::vector<LoopStory> loops;  ///< and near misses
  double metres = 1;       ///< metres per unit of the run; other than 1 only with Alignment::Sim3
  bool has_metres = true;  ///< false: the scale is unknown, and there is no truth to determine it

  /// The trajectory at which the activity of the cells is measured.
  const evaluation::Trajectory& places() const { return metrics.map.scores ? truth : map; }
};

/// The loops of a run, without its other figures.
Result<LoopRecord> readLoops(const record::RunReader& reader,
                             const config::EvaluationSettings& settings);

/// InvalidInput if the record is damaged or empty. `seed`: seed of the run, for the scores by
/// chance.
Result<RunData> readRun(const record::RunReader& reader, const config::EvaluationSettings& settings,
                        std::uint64_t seed = 1);

}  // namespace tolman::report
