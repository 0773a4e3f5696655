// SPDX-License-Identifier: BSD-3-Clause
// What the results of a run are made from, read once from its record.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "config/settings.hpp"
#include "evaluation/metrics.hpp"
#include "evaluation/trajectory.hpp"
#include "record/run_reader.hpp"

namespace tolman::report {

/// One error figure a frame that has a truth.
struct ErrorSeries {
  std::vector<double> seconds;  ///< data time since the first frame of the run
  std::vector<double> metres;
};

struct RunData {
  std::string name;
  evaluation::Trajectory truth;  ///< where the map's alignment puts it: in the world of the run
  evaluation::Trajectory odometry;
  evaluation::Trajectory map;
  ErrorSeries odometry_error;
  ErrorSeries map_error;
  MapGraph graph;
  evaluation::Metrics metrics;
};

/// InvalidInput for a record that is damaged or empty.
Result<RunData> readRun(const record::RunReader& reader,
                        const config::EvaluationSettings& settings);

}  // namespace tolman::report
