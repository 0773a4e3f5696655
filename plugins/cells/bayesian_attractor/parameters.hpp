// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the Bayesian attractor, with the constants of the paper's authors as defaults.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <tuple>

#include "tolman/parameters.hpp"

namespace tolman::bayesian_attractor {

/// When the cells inhibit each other.
enum class Inhibition : std::uint8_t {
  EveryView,      ///< with each view: the pace does not depend on how often the recogniser looks
  EveryFrame,     ///< with each frame, as in the paper, where every frame is a view
  FamiliarViews,  ///< with each view that may inject: novel ones only try the patience
};
inline constexpr std::array<std::string_view, 3> kInhibitionNames = {"every_view", "every_frame",
                                                                     "familiar_views"};
constexpr std::span<const std::string_view> enumNames(Inhibition) { return kInhibitionNames; }

/// How bumps on the head direction ring combine.
enum class RingBump : std::uint8_t { Gaussian, VonMises };
inline constexpr std::array<std::string_view, 2> kRingBumpNames = {"gaussian", "von_mises"};
constexpr std::span<const std::string_view> enumNames(RingBump) { return kRingBumpNames; }

struct AttractorParameters {
  double energy_heading = 100;
  double energy_position = 1;
  RingBump ring_bump = RingBump::VonMises;
  double period = 15;
  double metres_per_cell = 10;
  int modules = 1;
  double module_ratio = 1.4142135623730951;
  double initial_calibration = 0.1;
  double floor = 1e-4;
  double injected_strength = 0.4;
  double metric_strength = 4.0;
  double inhibition_of_calibration = 0.2;
  double inhibition_of_integrator = 0.2;
  Inhibition inhibition = Inhibition::FamiliarViews;
  double lost_trust = 0.5;
  bool consistency_gate = true;
  double gate_heading = 0.1;
  double gate_position = 0.3;
  double decision_heading = 0.2;
  double decision_position = 1.0;
  double decision_share = 0.5;
  int patience = 10;
  bool path_evidence = true;
  double evidence_prior = 0.05;
  double evidence_views = 100;
  double evidence_gate = 16;
  double decisive_odds = 20;
  int relocation_views = 3;
  double drift_heading = 1e-4;
  double drift_scale = 0.01;
  double view_sigma_position = 3;
  double view_sigma_heading = 0.2;
  double measured_sigma_position = 1;
  double measured_sigma_heading = 0.1;
  int newest_ignored = 10;
  int first_views_ignored = 50;
  double habituation_increment = 1.0;
  double habituation_recovery = 0.04;
  double experience_spacing = 5;
  double experience_turn = 0.5;
  double novel_spacing = 1;
  double loop_minimum_travel = 30;
  double loop_spacing = 5;
  int ring_units = 36;
  int sheet_units = 30;
  double field_width = 0.11;

 private:
  static constexpr auto networkParameters() {
    using P = AttractorParameters;
    return parameters(
        parameter("energy_heading", &P::energy_heading)
            .range(0.01, 1e6)
            .unit("1/rad^2")
            .doc("Total precision E of the head direction ring; 100 is a bump of 0.1 rad."),
        parameter("energy_position", &P::energy_position)
            .range(0.01, 1e6)
            .unit("1/cell^2")
            .doc("Total precision E of each axis of the grid torus."),
        parameter("ring_bump", &P::ring_bump)
            .doc("How head direction bumps combine; gaussian as in the paper."),
        parameter("period", &P::period)
            .range(1, 1e4)
            .unit("cells")
            .doc("Period of the grid torus."),
        parameter("metres_per_cell", &P::metres_per_cell)
            .range(1e-4, 1e5)
            .unit("m")
            .doc("Scale of the grid; 10 for a car, about 0.1 for a small robot."),
        parameter("modules", &P::modules)
            .range(1, 8)
            .doc("Grid modules; places that share a phase in one differ in another."),
        parameter("module_ratio", &P::module_ratio)
            .range(1.01, 4)
            .doc("Period of a grid module against that of the one before."),
        parameter("initial_calibration", &P::initial_calibration)
            .range(0, 1)
            .doc("Precision of the calibration cells at the start, as a share of E."),
        parameter("floor", &P::floor)
            .range(1e-9, 1e-2)
            .doc("Smallest precision that inhibition leaves."),
        parameter("injected_strength", &P::injected_strength)
            .range(0, 100)
            .doc("Energy that a familiar view injects, in units of E."),
        parameter("metric_strength", &P::metric_strength)
            .range(0, 100)
            .doc("The same for a decisive view with a measured pose; 4 lets one decide alone."),
        parameter("inhibition_of_calibration", &P::inhibition_of_calibration)
            .range(0, 1)
            .doc("Delta_cali: how strongly the integrator cells inhibit the calibration cells."),
        parameter("inhibition_of_integrator", &P::inhibition_of_integrator)
            .range(0, 1)
            .doc("Delta_inte: how strongly the calibration cells inhibit the integrator cells."),
        parameter("inhibition", &P::inhibition).doc("When inhibition acts."),
        parameter("lost_trust", &P::lost_trust)
            .range(0, 1)
            .doc("Factor on the integrator's precision at each view while odometry is lost."));
  }

  static constexpr auto decisionParameters() {
    using P = AttractorParameters;
    return parameters(
        parameter("consistency_gate", &P::consistency_gate)
            .doc("A view that contradicts the calibration starts it afresh; off as in the paper."),
        parameter("gate_heading", &P::gate_heading)
            .range(0, 4)
            .unit("rad")
            .doc("Contradiction of a view and the calibration in heading."),
        parameter("gate_position", &P::gate_position)
            .range(0, 1e4)
            .unit("cells")
            .doc("Contradiction of a view and the calibration in position."),
        parameter("decision_heading", &P::decision_heading)
            .range(0, 4)
            .unit("rad")
            .doc("Familiar when estimate and calibration are nearer than this in heading."),
        parameter("decision_position", &P::decision_position)
            .range(0, 1e4)
            .unit("cells")
            .doc("Familiar when estimate and calibration are nearer than this in position."),
        parameter("decision_share", &P::decision_share)
            .range(0, 1)
            .doc("Familiar when the calibration holds more than this share of the energy."),
        parameter("patience", &P::patience)
            .range(0, 1000000)
            .unit("views")
            .doc("A calibration that no view supports for longer is dropped."),
        parameter("newest_ignored", &P::newest_ignored)
            .range(0, 1000000)
            .unit("templates")
            .doc("So many of the newest templates do not inject."),
        parameter("first_views_ignored", &P::first_views_ignored)
            .range(0, 1000000)
            .unit("views")
            .doc("No view injects before so many have been seen."),
        parameter("habituation_increment", &P::habituation_increment)
            .range(0, 30)
            .doc("Habituation of a view that comes twice in a row."),
        parameter("habituation_recovery", &P::habituation_recovery)
            .range(0, 30)
            .doc("Recovery from habituation with each view."));
  }

  static constexpr auto evidenceParameters() {
    using P = AttractorParameters;
    return parameters(
        parameter("path_evidence", &P::path_evidence)
            .doc("Weigh each familiar view against path integration; off as in the paper."),
        parameter("evidence_prior", &P::evidence_prior)
            .range(1e-6, 0.999)
            .doc("Share of familiar views that is expected to be right, before any was seen."),
        parameter("evidence_views", &P::evidence_views)
            .range(0.1, 1e12)
            .unit("views")
            .doc("So many views weigh as much as that expectation."),
        parameter("evidence_gate", &P::evidence_gate)
            .range(0.1, 1e9)
            .doc("Chi-square (3 degrees of freedom) from which path integration rules a view out."),
        parameter("decisive_odds", &P::decisive_odds)
            .range(1, 1e12)
            .doc("Odds of right against wrong at which a view with a measured pose decides alone."),
        parameter("relocation_views", &P::relocation_views)
            .range(2, 1000)
            .unit("views")
            .doc("So many views must agree where a robot is that woke up somewhere."),
        parameter("drift_heading", &P::drift_heading)
            .range(0, 1)
            .unit("rad/m")
            .doc("Standard deviation of a constant pull of odometry to one side."),
        parameter("drift_scale", &P::drift_scale)
            .range(0, 1)
            .doc("Standard deviation of the scale of odometry."),
        parameter("view_sigma_position", &P::view_sigma_position)
            .range(1e-6, 1e6)
            .unit("m")
            .doc("How far from its template a view without measured pose may be."),
        parameter("view_sigma_heading", &P::view_sigma_heading)
            .range(1e-6, 10)
            .unit("rad")
            .doc("The same for its heading."),
        parameter("measured_sigma_position", &P::measured_sigma_position)
            .range(1e-6, 1e6)
            .unit("m")
            .doc("Doubt added to the measured pose of a view."),
        parameter("measured_sigma_heading", &P::measured_sigma_heading)
            .range(1e-6, 10)
            .unit("rad")
            .doc("The same for its heading."));
  }

  static constexpr auto experienceParameters() {
    using P = AttractorParameters;
    return parameters(
        parameter("experience_spacing", &P::experience_spacing)
            .range(0, 1e6)
            .unit("m")
            .doc("A new experience is made at this distance from the last."),
        parameter("experience_turn", &P::experience_turn)
            .range(0, 4)
            .unit("rad")
            .doc("A new experience is made when turned so far since the last."),
        parameter("novel_spacing", &P::novel_spacing)
            .range(0, 1e6)
            .unit("m")
            .doc("A novel view makes a new experience at this distance from the last already."),
        parameter("loop_minimum_travel", &P::loop_minimum_travel)
            .range(0, 1e9)
            .unit("m")
            .doc("Loops are closed only to experiences that were left so long a way ago."),
        parameter("loop_spacing", &P::loop_spacing)
            .range(0, 1e9)
            .unit("m")
            .doc("Way between two loop links."),
        parameter("ring_units", &P::ring_units)
            .range(2, 3600)
            .unit("cells")
            .doc("Head direction cells in the recorded activity."),
        parameter("sheet_units", &P::sheet_units)
            .range(2, 512)
            .unit("cells")
            .doc("Grid cells along each side of the recorded sheet."),
        parameter("field_width", &P::field_width)
            .range(0, 0.5)
            .unit("periods")
            .doc("Standard deviation of a recorded grid cell's own field, beside that of the bump; "
                 "0 records the bump alone. The default makes fields as wide against their spacing "
                 "as in the rat (Hafting et al., Nature 2005). Nothing but the recorded activity "
                 "depends on it."));
  }

 public:
  static constexpr auto declaration() {
    return std::tuple_cat(networkParameters(), decisionParameters(), evidenceParameters(),
                          experienceParameters());
  }
};

}  // namespace tolman::bayesian_attractor
