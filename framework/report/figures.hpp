// SPDX-License-Identifier: BSD-3-Clause
// The figures of a report, each as SVG text, empty where the record has no data for it; and the
// firing of single units, drawn and as numbers: neurons.json.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/run_data.hpp"
#include "tolman/status.hpp"

namespace tolman::report {

/// Most panels of one figure: a taller one could not be drawn as PNG. Further populations are left
/// out.
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

/// The view from above with equal scales and a legend.
std::string mapFigure(const MapPicture& picture);

/// Position error of odometry and map over time.
std::string errorFigure(const RunData& run);

/// Lengths and turns of short stretches against true ones: where one is broken or in other units.
std::string stepFigure(const RunData& run);

/// The template of each frame, as in the paper: new ones along the upper bound.
std::string templateFigure(const std::vector<PlaceObservation>& places);

/// Time of each stage, median and 90th percentile.
std::string timingFigure(const evaluation::Metrics& metrics);

/// A unit that is drawn by itself.
struct DrawnUnit {
  std::string name;      ///< with indices from 1
  std::string measures;  ///< in words
  evaluation::RateMap rates;
  std::vector<Eigen::Vector2d> fields{};  ///< centres of the fields of a grid unit
};

/// The first unit of the first ring, its opposite, and the first unit of the first sheet.
std::vector<DrawnUnit> drawnUnits(const RunData& run);

/// The firing rate maps of single units.
std::string firingFigure(const std::vector<DrawnUnit>& units);

/// Firing of all units: tuning curves of each ring, and the rate maps of each grid module.
std::string unitsFigure(const RunData& run);

/// Angles in degrees, units from 1; `nominal` as the axis is described. Null without units.
nlohmann::ordered_json neuronsJson(const RunData& run);
// One self-contained HTML page about one run, or several side by side.

struct PageFigure {
  std::string file;  ///< name without extension, "error"
  std::string caption;
  std::string svg;
};

/// The part of a page about one run.
struct RunPage {
  RunData data;
  std::string directory;  ///< name of the run directory, unique among the runs of one page
  std::vector<PageFigure> figures;
  nlohmann::ordered_json neurons;     ///< neuronsJson()
  nlohmann::ordered_json provenance;  ///< run.json; null where it is missing
  std::string config;                 ///< config.resolved.yaml
  bool killed = false;                ///< the run was killed
};

/// Draws the figures of a run.
RunPage makePage(const std::filesystem::path& directory, RunData data);

std::string html(const std::vector<RunPage>& runs);

}  // namespace tolman::report
