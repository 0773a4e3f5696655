// SPDX-License-Identifier: BSD-3-Clause
// The experience map as a picture: map.svg.
#pragma once

#include <string>

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

/// Seen from above; equal scales, a scale bar, a legend.
std::string svgText(const MapPicture& picture);

}  // namespace tolman::report
