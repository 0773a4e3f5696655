// SPDX-License-Identifier: BSD-3-Clause
// The figures of a report, each as SVG text, empty where the record has no data for it; and the
// firing of single units, drawn and as numbers: neurons.json.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/run_data.hpp"
#include "tolman/status.hpp"

namespace tolman::report {

/// Most panels of one figure: a taller one could not be drawn as PNG. Further arrays are left out.
inline constexpr std::size_t kMaxPanels = 40;

/// What is drawn of a map, in the world frame of the run. The truth may be empty.
struct MapPicture {
  std::string title;
  std::string unit = "m";        ///< of all lengths
  evaluation::Trajectory truth;  ///< already aligned with the map
  evaluation::Trajectory odometry;
  evaluation::Trajectory map;
  MapGraph graph;
};

/// The picture of a run, in metres; if the scale is unknown, in the arbitrary units of the run.
MapPicture pictureOf(const RunData& run, std::string title);

/// Views from above with equal scales and a legend: one panel per run, all with the same axes; the
/// titles of several begin with a letter.
std::string mapFigure(const std::vector<MapPicture>& pictures);

/// Position error of odometry and map over time.
std::string errorFigure(const RunData& run);

/// Lengths and turns of short stretches against true ones: where one is broken or in other units.
std::string stepFigure(const RunData& run);

/// Height of odometry, map and truth over the driven distance; empty where all stay level.
std::string elevationFigure(const RunData& run);

/// The template of each frame, as in the paper: new ones along the upper bound.
std::string templateFigure(const std::vector<PlaceObservation>& places);

/// Time of each stage, median and 90th percentile.
std::string timingFigure(const evaluation::Metrics& metrics);

/// Activity of head direction rings and grid modules at the start, and at thirds of the run.
std::string activityFigure(const evaluation::CellHistory& cells,
                           const std::vector<Decision>& decisions);

/// Each array over time: lines for up to six values, else a heat map.
std::string arrayFigure(const std::vector<evaluation::PopulationHistory>& arrays);

/// The units to draw, by indices from 0 in the first ring and the first sheet. For the ring the
/// unit of the opposite heading is drawn as well.
struct UnitChoice {
  std::size_t head_direction = 0;
  std::size_t row = 0;
  std::size_t column = 0;
};

struct DrawnUnit {
  std::string name;      ///< with indices from 1
  std::string measures;  ///< in words
  evaluation::RateMap rates;
  std::vector<Eigen::Vector2d> fields{};  ///< centres of the fields of a grid unit
};

/// Units of the ring first. InvalidParameter for a unit that the run does not have.
Result<std::vector<DrawnUnit>> drawnUnits(const RunData& run, const UnitChoice& choice);

/// The firing rate maps of single units.
std::string firingFigure(const std::vector<DrawnUnit>& units);

/// Firing of all units: tuning curves of each ring, and the rate maps of each grid module.
std::string unitsFigure(const RunData& run);

/// Angles in degrees, units from 1; `nominal` as the axis is described. Null without units.
nlohmann::ordered_json neuronsJson(const RunData& run, const std::vector<DrawnUnit>& drawn);
/// A rate map as rows from its corner to the right, null in bins without visits.
nlohmann::ordered_json toJson(const evaluation::RateMap& map);

}  // namespace tolman::report
