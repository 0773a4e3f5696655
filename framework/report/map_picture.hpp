// SPDX-License-Identifier: BSD-3-Clause
// Draws experience maps: map.svg, and the maps of several runs side by side.
#pragma once

#include <string>
#include <vector>

#include "evaluation/trajectory.hpp"
#include "tolman/records.hpp"

namespace tolman::report {

/// Contents of the picture, in the world frame of the run. The truth may be empty.
struct MapPicture {
  std::string title;
  evaluation::Trajectory truth;  ///< already aligned with the map
  evaluation::Trajectory odometry;
  evaluation::Trajectory map;
  MapGraph graph;
};

/// Seen from above; equal scales, axes in metres, a legend.
std::string svgText(const MapPicture& picture);

/// One panel per run, all with the same axes.
std::string comparisonText(const std::vector<MapPicture>& pictures);

}  // namespace tolman::report
