// SPDX-License-Identifier: BSD-3-Clause
// Distance to the streets and height of the ground, on grids.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "ground_grid.hpp"
#include "street_path.hpp"

namespace tolman::town {

/// The rectangle that a grid covers.
struct GridExtent {
  Eigen::Vector2d low;   ///< m
  Eigen::Vector2d high;  ///< m
};

/// m to the nearest centreline, exact at the grid's points, at most `farthest`. Cells of 0.5 m,
/// larger where more than 64 MB would be needed.
GroundGrid distanceGrid(const std::vector<PathPoint>& path, const GridExtent& extent,
                        double farthest);

/// How firmly passes agree on a height.
struct HeightAgreement {
  double bend_length = 15;  ///< m, over which a correction fades out along the street
  double weight = 200;      ///< of a meeting, beside 1 of a measured height
  bool is_stiff = false;    ///< corrections bend like a beam, without a kink where passes meet
};

/// Heights of the road at the path's points: where passes overlap, the path's own heights are bent
/// to their mean, gently along the street.
std::vector<double> agreeOnHeights(const std::vector<PathPoint>& path,
                                   const HeightAgreement& agreement = {});

/// Height of the ground: the streets' heights, level across, and a membrane between the streets
/// that settles to `mean` + farHills() away from them. Cells of 1 m or larger: 16 MB at most.
GroundGrid heightGrid(const std::vector<PathPoint>& path, const std::vector<double>& heights,
                      const GroundGrid& distance, const GridExtent& extent, double mean,
                      const std::vector<GroundPad>& pads = {});

/// m, the hills that no street lies on.
double farHills(double x, double y);

}  // namespace tolman::town
