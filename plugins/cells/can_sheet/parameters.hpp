// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the attractor sheets. I, T, sigma and tau are the paper's; the sources of the
// others stand beside them.
#pragma once

#include <tuple>

#include "tolman/parameters.hpp"

namespace tolman::can_sheet {

/// m driven between two views that inject.
inline constexpr double kViewSpacing = 1;  // m; chosen, not tuned

struct CanSheetParameters {
  double period = 100;            // m; chosen, not tuned
  int modules = 3;                // chosen, not tuned
  double ratio = 1.42;            // of the rat (Stensola et al. 2012)
  double orientation = 0.13;      // rad; 7.5 degrees in the rat
  int units = 40;                 // chosen, not tuned: bounds the time (README.md)
  double injection = 0.05;        // best of six pairs on KITTI 00 and 06 (README.md)
  double agreement = 0.1;         // periods; as `injection`
  double experience_spacing = 5;  // m; this and those below: chosen, not tuned
  double experience_turn = 0.5;
  double loop_minimum_travel = 30;
  double loop_spacing = 5;

 private:
  static constexpr auto network() {
    using P = CanSheetParameters;
    return parameters(
        parameter("period", &P::period)
            .range(1e-3, 1e6)
            .unit("m")
            .doc(
                "Distance of neighbouring fields in the smallest module: the inverse of its gain."),
        parameter("modules", &P::modules).range(1, 6).doc("Number of grid modules."),
        parameter("ratio", &P::ratio)
            .range(1, 10)
            .doc("Period of a module relative to that of the next smaller one."),
        parameter("orientation", &P::orientation)
            .range(-4, 4)
            .unit("rad")
            .doc("Direction of an axis of the grids from the heading at the start; 7.5 degrees in "
                 "the rat."),
        parameter("units", &P::units)
            .range(8, 48)
            .unit("cells")
            .doc("Units along each of the two axes of a module; the time of a step grows with the "
                 "fourth power of their number."));
  }

  static constexpr auto decisions() {
    using P = CanSheetParameters;
    return parameters(
        parameter("injection", &P::injection)
            .range(0, 10)
            .doc("What a familiar view adds at its place, as a share of the activity; 0: views "
                 "close loops only where they agree."),
        parameter("agreement", &P::agreement)
            .range(0.001, 0.5)
            .unit("periods")
            .doc("A familiar view whose place is nearer than this in all modules closes a loop."),
        parameter("experience_spacing", &P::experience_spacing)
            .range(0, 1e6)
            .unit("m")
            .doc("A new experience is made at this distance from the last one made."),
        parameter("experience_turn", &P::experience_turn)
            .range(0, 4)
            .unit("rad")
            .doc("A new experience is made after this turn since the last one made."),
        parameter("loop_minimum_travel", &P::loop_minimum_travel)
            .range(0, 1e9)
            .unit("m")
            .doc(
                "Views whose template was made less than this travelled distance ago are ignored."),
        parameter("loop_spacing", &P::loop_spacing)
            .range(0, 1e9)
            .unit("m")
            .doc("Shortest travelled distance between two loop links."));
  }

 public:
  static constexpr auto declaration() { return std::tuple_cat(network(), decisions()); }
};

}  // namespace tolman::can_sheet
