// SPDX-License-Identifier: BSD-3-Clause
// Experience maps as pictures: map.svg, and the maps of several runs beside each other.
#pragma once

#include <string>
#include <vector>

#include "evaluation/trajectory.hpp"
#include "tolman/records.hpp"

namespace tolman::report {

/// What the picture shows; the truth may be empty. All in the world frame of the run.
struct MapPicture {
  std::string title;
  evaluation::Trajectory truth;  ///< already aligned with the map
  evaluation::Trajectory odometry;
  evaluation::Trajectory map;
  MapGraph graph;
};

/// Seen from above; equal scales, axes in metres, a legend.
std::string svgText(const MapPicture& picture);

/// One panel a run, all with the same axes: what differs is what the systems made of the drive.
std::string comparisonText(const std::vector<MapPicture>& pictures);

}  // namespace tolman::report
