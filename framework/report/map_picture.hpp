// SPDX-License-Identifier: BSD-3-Clause
// Draws experience maps: map.svg, and the maps of several runs side by side.
#pragma once

#include <string>
#include <vector>

#include "evaluation/trajectory.hpp"
#include "report/run_data.hpp"
#include "tolman/records.hpp"

namespace tolman::report {

/// Contents of the picture, in the world frame of the run. The truth may be empty.
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

}  // namespace tolman::report
