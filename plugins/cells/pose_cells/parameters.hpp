// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the pose cells; the defaults are those published for the car data set (St
// Lucia; OpenRatSLAM), but for the shift and the injection.
#pragma once

#include "tolman/parameters.hpp"

namespace tolman::pose_cells {

/// Kernels (cells, cells^2) and inhibition of the network, as published.
inline constexpr int kExcitationWidth = 7;
inline constexpr double kExcitationVariance = 1;
inline constexpr int kInhibitionWidth = 5;
inline constexpr double kInhibitionVariance = 2;
inline constexpr double kGlobalInhibition = 2e-5;

/// Lowest habituation of a view, and its increase when the view is repeated at once; RatSLAM's.
inline constexpr double kActiveDecay = 1;

struct PoseCellParameters {
  int side = 30;
  int headings = 36;
  double cell_size = 2;
  double least_shift = 1;         // cells; chosen on KITTI 00 and 06 (README.md); 0 as published
  double injected_energy = 0.25;  // best of 29 combinations on 00 and 06; 0.15 as published
  double unsupported = 0.1;       // as `injected_energy`; 1 as published
  double restore = 0.04;
  int newest_ignored = 10;
  double experience_threshold = 1;

  static constexpr auto declaration() {
    using P = PoseCellParameters;
    return parameters(
        parameter("side", &P::side).range(7, 200).unit("cells").doc("Cells in x and in y."),
        parameter("headings", &P::headings).range(7, 360).unit("cells").doc("Cells in theta."),
        parameter("cell_size", &P::cell_size)
            .range(1e-4, 1e4)
            .unit("m")
            .doc("Side of a cell; 2 for a car, 0.015 for a toy."),
        parameter("least_shift", &P::least_shift)
            .range(0, 2)
            .unit("cells")
            .doc("Motions and turns are added up to this length before they shift the activity; 0, "
                 "as "
                 "published: at once."),
        parameter("injected_energy", &P::injected_energy)
            .range(0, 10)
            .doc("Energy that a familiar view without additional habituation adds where the "
                 "activity "
                 "packet is; 0.15 as published."),
        parameter("unsupported", &P::unsupported)
            .range(0, 1)
            .doc("Share of injected_energy that a view adds where all cells are silent; 1 as "
                 "published."),
        parameter("restore", &P::restore)
            .range(0, 30)
            .doc("Recovery from habituation with each view."),
        parameter("newest_ignored", &P::newest_ignored)
            .range(0, 1000000)
            .unit("templates")
            .doc("Number of the newest templates, which do not inject."),
        parameter("experience_threshold", &P::experience_threshold)
            .range(0.01, 1e4)
            .unit("cells")
            .doc("Smallest distance between experiences."));
  }
};

}  // namespace tolman::pose_cells
