// SPDX-License-Identifier: BSD-3-Clause
// The parameters of NeuroSLAM's cells. Defaults are those of the published program for its
// synthetic panoramas, where there are any; those of cell_size, cell_height and
// experience_threshold are not, because the published ones are in units of its odometry.
#pragma once

#include <tuple>

#include "tolman/parameters.hpp"

namespace tolman::neuroslam_cells {

struct Parameters {
  int side = 36;
  int headings = 36;
  double cell_size = 2;      // m; RatSLAM's for a car (St Lucia)
  double cell_height = 0.5;  // m; a sixth of a storey (README.md)
  int grid_excitation_width = 7;
  double grid_excitation_sigma = 1.5;
  int grid_inhibition_width = 5;
  double grid_inhibition_sigma = 2;
  double grid_global_inhibition = 2.5e-4;
  double grid_injected_energy = 0.01;
  int grid_packet = 4;
  int head_excitation_width = 9;  // 8 as published, but widths are odd here
  double head_excitation_sigma = 1.9;
  int head_inhibition_width = 5;
  double head_inhibition_sigma = 3.1;
  double head_global_inhibition = 3e-4;
  double head_injected_energy = 0.01;
  int head_packet = 5;
  double active_decay = 2;
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
            .doc("Height of a grid cell, and of a layer of head direction cells."),
        parameter("grid_excitation_width", &P::grid_excitation_width)
            .range(1, 9)
            .unit("cells")
            .doc("Width of the excitatory kernel of the grid cells, odd."),
        parameter("grid_excitation_sigma", &P::grid_excitation_sigma)
            .range(0.1, 10)
            .unit("cells")
            .doc("Its standard deviation."),
        parameter("grid_inhibition_width", &P::grid_inhibition_width)
            .range(1, 9)
            .unit("cells")
            .doc("Width of the inhibitory kernel of the grid cells, odd."),
        parameter("grid_inhibition_sigma", &P::grid_inhibition_sigma)
            .range(0.1, 10)
            .unit("cells")
            .doc("Its standard deviation."),
        parameter("grid_global_inhibition", &P::grid_global_inhibition)
            .range(0, 1)
            .doc("Taken from every grid cell in each step; the total activity is 1."),
        parameter("grid_injected_energy", &P::grid_injected_energy)
            .range(0, 10)
            .doc("Energy that a familiar view without additional habituation adds to the grid "
                 "cells."),
        parameter("grid_packet", &P::grid_packet)
            .range(1, 10)
            .unit("cells")
            .doc("Distance from the strongest grid cell within which activity counts for the "
                 "estimate."));
  }

  static constexpr auto headParameters() {
    using P = Parameters;
    return parameters(
        parameter("headings", &P::headings)
            .range(9, 360)
            .unit("cells")
            .doc("Head direction cells of a layer."),
        parameter("head_excitation_width", &P::head_excitation_width)
            .range(1, 9)
            .unit("cells")
            .doc("Width of the excitatory kernel of the head direction cells, odd; 8 as "
                 "published."),
        parameter("head_excitation_sigma", &P::head_excitation_sigma)
            .range(0.1, 10)
            .unit("cells")
            .doc("Its standard deviation."),
        parameter("head_inhibition_width", &P::head_inhibition_width)
            .range(1, 9)
            .unit("cells")
            .doc("Width of the inhibitory kernel of the head direction cells, odd."),
        parameter("head_inhibition_sigma", &P::head_inhibition_sigma)
            .range(0.1, 10)
            .unit("cells")
            .doc("Its standard deviation."),
        parameter("head_global_inhibition", &P::head_global_inhibition)
            .range(0, 1)
            .doc("Taken from every head direction cell in each step; the total activity is 1."),
        parameter("head_injected_energy", &P::head_injected_energy)
            .range(0, 10)
            .doc("Energy that a familiar view without additional habituation adds to the head "
                 "direction cells."),
        parameter("head_packet", &P::head_packet)
            .range(1, 10)
            .unit("cells")
            .doc("Distance from the strongest head direction cell within which activity counts for "
                 "the estimate."));
  }

  static constexpr auto viewParameters() {
    using P = Parameters;
    return parameters(
        parameter("active_decay", &P::active_decay)
            .range(0, 30)
            .doc("Initial and lowest habituation of a view, and its increase when the view is "
                 "repeated at once."),
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
