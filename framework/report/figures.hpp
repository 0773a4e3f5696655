// SPDX-License-Identifier: BSD-3-Clause
// The figures of a report, each as SVG text; empty where the record has no data for it.
#pragma once

#include <string>
#include <vector>

#include "report/cell_history.hpp"
#include "report/drawn_units.hpp"
#include "report/neurons.hpp"
#include "report/run_data.hpp"

namespace tolman::report {

/// Position error of odometry and map over time.
std::string errorFigure(const RunData& run);

/// The paper's graph of the local view template over time: new ones along the upper bound,
/// familiar ones below it.
std::string templateFigure(const std::vector<PlaceObservation>& places);

/// Activity of head direction ring and grid sheet at the start, and at thirds of the run.
std::string activityFigure(const CellHistory& cells, const std::vector<Decision>& decisions);

/// Each array over time: lines for up to five values, else a heat map.
std::string arrayFigure(const std::vector<PopulationHistory>& arrays);

/// Where single units fire on the path of the map, with the tuning curve of the first.
std::string firingFigure(const Neurons& neurons, const std::vector<DrawnUnit>& units);

/// Time of each stage, median and 90th percentile.
std::string timingFigure(const evaluation::Metrics& metrics);

}  // namespace tolman::report
