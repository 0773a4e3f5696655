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

/// Distance to the nearest centreline, m, at most `farthest`, exact at the grid points. Cells are
/// of 0.5 m, or larger if more than 64 MB would be needed.
GroundGrid distanceGrid(const std::vector<PathPoint>& path, const GridExtent& extent,
                        double farthest);

/// Weights of the agreement of passes on a height.
struct HeightAgreement {
  double bend_length = 15;  ///< m, over which a correction fades out along the street
  double weight = 200;      ///< weight of a meeting; that of a measured height is 1
  bool is_stiff = false;  ///< corrections are smooth as of a bent beam, without a kink at meetings
};

/// Heights of the road at the points of the path, m. Where passes overlap, they are corrected to
/// the mean; corrections change smoothly along the street.
std::vector<double> agreeOnHeights(const std::vector<PathPoint>& path,
                                   const HeightAgreement& agreement = {});

/// Height of the ground, m: that of the streets, level across, and a membrane between the streets
/// that approaches `mean` + farHills() far from them. Cells are of 1 m or larger, so 16 MB at most.
GroundGrid heightGrid(const std::vector<PathPoint>& path, const std::vector<double>& heights,
                      const GroundGrid& distance, const GridExtent& extent, double mean,
                      const std::vector<GroundPad>& pads = {});

/// Height of the hills far from streets, m.
double farHills(double x, double y);

}  // namespace tolman::town
