// SPDX-License-Identifier: BSD-3-Clause
// The parameters of NeuroSLAM's cells. Defaults are those of the published program for its
// synthetic panoramas, where there are any; those of cell_size, cell_height and
// experience_threshold are not, because the published ones are in units of its odometry.
#pragma once

#include <tuple>

#include "tolman/parameters.hpp"

namespace tolman::neuroslam_cells {

/// Kernels (cells, cells^2), inhibition and packets of the network, as published.
inline constexpr int kGridExcitationWidth = 7;
inline constexpr double kGridExcitationVariance = 1.5 * 1.5;
inline constexpr int kGridInhibitionWidth = 5;
inline constexpr double kGridInhibitionVariance = 2 * 2;
inline constexpr double kGridGlobalInhibition = 2.5e-4;
inline constexpr int kGridPacket = 4;
inline constexpr int kHeadExcitationWidth = 9;  // 8 as published, but widths are odd here
inline constexpr double kHeadExcitationVariance = 1.9 * 1.9;
inline constexpr int kHeadInhibitionWidth = 5;
inline constexpr double kHeadInhibitionVariance = 3.1 * 3.1;
inline constexpr double kHeadGlobalInhibition = 3e-4;
inline constexpr double kHeadInjectedEnergy = 0.01;
inline constexpr int kHeadPacket = 5;

/// Energy that a familiar view without additional habituation adds to the grid cells; its lowest
/// habituation, and the increase when it is repeated at once. As published.
inline constexpr double kGridInjectedEnergy = 0.01;
inline constexpr double kActiveDecay = 2;

struct Parameters {
  int side = 36;
  int headings = 36;
  double cell_size = 2;      // m; RatSLAM's for a car (St Lucia)
  double cell_height = 0.5;  // m; a sixth of a storey (README.md)
  double restore = 0.5;
  double experience_threshold = 2;  // cells; the code default of OpenRatSLAM

 private:
  static constexpr auto gridParameters() {
    using P = Parameters;
    return parameters(
        parameter("side", &P::side)
            .range(9, 100)
            .unit("cells")
            .doc("Grid cells in x, y and height, and layers of head direction cells."),
        parameter("cell_size", &P::cell_size)
            .range(1e-4, 1e4)
            .unit("m")
            .doc("Side of a grid cell in x and y."),
        parameter("cell_height", &P::cell_height)
            .range(1e-4, 1e4)
            .unit("m")
            .doc("Height of a grid cell, and of a layer of head direction cells."));
  }

  static constexpr auto headParameters() {
    using P = Parameters;
    return parameters(parameter("headings", &P::headings)
                          .range(9, 360)
                          .unit("cells")
                          .doc("Head direction cells of a layer."));
  }

  static constexpr auto viewParameters() {
    using P = Parameters;
    return parameters(
        parameter("restore", &P::restore)
            .range(0, 30)
            .doc("Recovery from habituation with each view."),
        parameter("experience_threshold", &P::experience_threshold)
            .range(0.01, 1e4)
            .unit("cells")
            .doc("Smallest distance between two experiences of a view, over x, y, height and "
                 "heading."));
  }

 public:
  static constexpr auto declaration() {
    return std::tuple_cat(gridParameters(), headParameters(), viewParameters());
  }
};

}  // namespace tolman::neuroslam_cells
