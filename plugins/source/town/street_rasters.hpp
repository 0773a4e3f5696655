// SPDX-License-Identifier: BSD-3-Clause
// Distance to the streets and height of the ground, on grids.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "raster.hpp"
#include "street_path.hpp"

namespace tolman::town {

/// What a grid covers.
struct Extent {
  Eigen::Vector2d low;   ///< m
  Eigen::Vector2d high;  ///< m
};

/// m to the nearest centreline, exact at the grid's points, at most `farthest`. Cells of 0.5 m,
/// larger where more than 64 MB would be needed.
Raster rasterDistance(const std::vector<PathPoint>& path, const Extent& extent, double farthest);

/// Heights of the road at the path's points: where passes overlap, the path's own heights are bent
/// to their mean, gently along the street.
std::vector<double> agreeOnHeights(const std::vector<PathPoint>& path);

/// Height of the ground: the streets' heights, level across, and a membrane between the streets
/// that settles to `mean` + farHills() away from them. Cells of 1 m or larger: 16 MB at most.
Raster rasterHeight(const std::vector<PathPoint>& path, const std::vector<double>& heights,
                    const Raster& distance, const Extent& extent, double mean);

/// m, the hills that no street lies on.
double farHills(double x, double y);

}  // namespace tolman::town
