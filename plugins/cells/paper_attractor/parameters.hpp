// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the paper's network, whose values the paper does not name. Where nothing else
// is said the default is that of a public program that is descended from the authors' own
// (iRobotVision/Hybird-NeuroSLAM).
#pragma once

#include <tuple>

#include "tolman/parameters.hpp"

namespace tolman::paper_attractor {

/// Total precisions E (1/rad^2, 1/cell^2), and what no drive asks to change.
inline constexpr double kEnergyHeading = 100;
inline constexpr double kEnergyPosition = 1;
inline constexpr double kFloor = 1e-4;
inline constexpr double kLostTrust = 0.5;  // chosen, not tuned
inline constexpr double kNovelSpacing = 1;

struct PaperAttractorParameters {
  double period = 15;
  double metres_per_cell = 10;
  double initial_calibration = 0.1;
  double injected_strength = 0.4;
  double inhibition_of_calibration = 0.2;
  double inhibition_of_integrator = 0.2;  // as the other one: the paper's symmetric form
  double decision_heading = 0.1;          // rad; chosen, not tuned
  double decision_position = 0.2;         // cells; chosen, not tuned
  int newest_ignored = 10;
  int first_views_ignored = 50;
  double experience_spacing = 5;  // m; this and those below: chosen, not tuned
  double experience_turn = 0.5;
  double loop_minimum_travel = 30;
  double loop_spacing = 5;

 private:
  static constexpr auto networkParameters() {
    using P = PaperAttractorParameters;
    return parameters(
        parameter("period", &P::period)
            .range(1, 1e4)
            .unit("cells")
            .doc("Period of the grid torus."),
        parameter("metres_per_cell", &P::metres_per_cell)
            .range(1e-4, 1e5)
            .unit("m")
            .doc("Scale of the grid; 10 for a car, about 0.1 for a small robot."),
        parameter("initial_calibration", &P::initial_calibration)
            .range(0, 1)
            .doc("Precision of the calibration cells at the start, as a share of E."),
        parameter("injected_strength", &P::injected_strength)
            .range(0, 100)
            .doc("Energy that a familiar view injects, in units of E."),
        parameter("inhibition_of_calibration", &P::inhibition_of_calibration)
            .range(0, 1)
            .doc("Delta_cali: how strongly the integrator cells inhibit the calibration cells."),
        parameter("inhibition_of_integrator", &P::inhibition_of_integrator)
            .range(0, 1)
            .doc("Delta_inte: how strongly the calibration cells inhibit the integrator cells."));
  }

  static constexpr auto decisionParameters() {
    using P = PaperAttractorParameters;
    return parameters(
        parameter("decision_heading", &P::decision_heading)
            .range(0, 4)
            .unit("rad")
            .doc("Familiar when estimate and calibration are nearer than this in heading."),
        parameter("decision_position", &P::decision_position)
            .range(0, 1e4)
            .unit("cells")
            .doc("Familiar when estimate and calibration are nearer than this in position."),
        parameter("newest_ignored", &P::newest_ignored)
            .range(0, 1000000)
            .unit("templates")
            .doc("Excludes the newest N templates from injection."),
        parameter("first_views_ignored", &P::first_views_ignored)
            .range(0, 1000000)
            .unit("views")
            .doc("No view injects before this many have been seen."));
  }

  static constexpr auto experienceParameters() {
    using P = PaperAttractorParameters;
    return parameters(
        parameter("experience_spacing", &P::experience_spacing)
            .range(0, 1e6)
            .unit("m")
            .doc("A new experience is made at this distance from the last."),
        parameter("experience_turn", &P::experience_turn)
            .range(0, 4)
            .unit("rad")
            .doc("A new experience is made after this turn since the last."),
        parameter("loop_minimum_travel", &P::loop_minimum_travel)
            .range(0, 1e9)
            .unit("m")
            .doc("Shortest travelled distance since an experience was left before a loop to it is "
                 "closed."),
        parameter("loop_spacing", &P::loop_spacing)
            .range(0, 1e9)
            .unit("m")
            .doc("Shortest travelled distance between two loop links."));
  }

 public:
  static constexpr auto declaration() {
    return std::tuple_cat(networkParameters(), decisionParameters(), experienceParameters());
  }
};

}  // namespace tolman::paper_attractor
