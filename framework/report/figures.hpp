// SPDX-License-Identifier: BSD-3-Clause
// The figures of a report, each as SVG text; empty where the record has no data for it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/run_data.hpp"
#include "report/units.hpp"

namespace tolman::report {

/// Most panels of one figure: a taller one could not be drawn as PNG. Further arrays are left out.
inline constexpr std::size_t kMaxPanels = 40;

/// Position error of odometry and map over time.
std::string errorFigure(const RunData& run);

/// Lengths and turns of short stretches of odometry and map against true ones, over time: where one
/// of them is broken or in other units.
std::string stepFigure(const RunData& run);

/// Height of odometry, map and truth over the driven distance; empty where all stay level.
std::string elevationFigure(const RunData& run);

/// The template of each frame over time, as in the paper: new ones along the upper bound, familiar
/// ones below it.
std::string templateFigure(const std::vector<PlaceObservation>& places);

/// Activity of head direction rings and grid modules at the start, and at thirds of the run.
std::string activityFigure(const evaluation::CellHistory& cells,
                           const std::vector<Decision>& decisions);

/// Each array over time: lines for up to five values, else a heat map.
std::string arrayFigure(const std::vector<evaluation::PopulationHistory>& arrays);

/// The firing rate maps of single units.
std::string firingFigure(const std::vector<DrawnUnit>& units);

/// Firing of all units: tuning curves of each ring, and the rate maps of each grid module.
std::string unitsFigure(const RunData& run);

/// Time of each stage, median and 90th percentile.
std::string timingFigure(const evaluation::Metrics& metrics);

}  // namespace tolman::report
