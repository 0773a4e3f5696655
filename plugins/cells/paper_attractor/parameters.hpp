// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the paper's network, whose values the paper does not name. Where nothing else
// is said the default is that of a public program that is descended from the authors' own
// (iRobotVision/Hybird-NeuroSLAM).
#pragma once

#include <tuple>

#include "tolman/parameters.hpp"

namespace tolman::paper_attractor {

struct PaperAttractorParameters {
  double energy_heading = 100;
  double energy_position = 1;
  double period = 15;
  double metres_per_cell = 10;
  double initial_calibration = 0.1;
  double floor = 1e-4;
  double injected_strength = 0.4;
  double inhibition_of_calibration = 0.2;
  double inhibition_of_integrator = 0.2;  // as the other one: the paper's symmetric form
  double lost_trust = 0.5;                // chosen, not tuned
  double decision_heading = 0.1;          // rad; chosen, not tuned
  double decision_position = 0.2;         // cells; chosen, not tuned
  int newest_ignored = 10;
  int first_views_ignored = 50;
  double habituation_increment = 1.0;  // RatSLAM's
  double habituation_recovery = 0.04;  // RatSLAM's for St Lucia
  double experience_spacing = 5;       // m; this and those below: chosen, not tuned
  double experience_turn = 0.5;
  double novel_spacing = 1;
  double loop_minimum_travel = 30;
  double loop_spacing = 5;

 private:
  static constexpr auto networkParameters() {
    using P = PaperAttractorParameters;
    return parameters(
        parameter("energy_heading", &P::energy_heading)
            .range(0.01, 1e6)
            .unit("1/rad^2")
            .doc("Total precision E of the head direction ring; 100 is a bump of 0.1 rad."),
        parameter("energy_position", &P::energy_position)
            .range(0.01, 1e6)
            .unit("1/cell^2")
            .doc("Total precision E of each axis of the grid torus."),
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
        parameter("floor", &P::floor)
            .range(1e-9, 1e-2)
            .doc("Smallest precision that inhibition leaves."),
        parameter("injected_strength", &P::injected_strength)
            .range(0, 100)
            .doc("Energy that a familiar view injects, in units of E."),
        parameter("inhibition_of_calibration", &P::inhibition_of_calibration)
            .range(0, 1)
            .doc("Delta_cali: how strongly the integrator cells inhibit the calibration cells."),
        parameter("inhibition_of_integrator", &P::inhibition_of_integrator)
            .range(0, 1)
            .doc("Delta_inte: how strongly the calibration cells inhibit the integrator cells."),
        parameter("lost_trust", &P::lost_trust)
            .range(0, 1)
            .doc("Factor on the integrator's precision at each view while odometry is lost."));
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
            .doc("No view injects before this many have been seen."),
        parameter("habituation_increment", &P::habituation_increment)
            .range(0, 30)
            .doc("Habituation that a view gains when it comes twice in a row."),
        parameter("habituation_recovery", &P::habituation_recovery)
            .range(0, 30)
            .doc("Recovery from habituation with each view."));
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
        parameter("novel_spacing", &P::novel_spacing)
            .range(0, 1e6)
            .unit("m")
            .doc("A novel view makes a new experience at this distance from the last."),
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
