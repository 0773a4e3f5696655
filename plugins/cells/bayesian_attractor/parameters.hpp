// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the network. docs/method.md has the source and the effect of each.
#pragma once

#include <tuple>

#include "tolman/parameters.hpp"

namespace tolman::bayesian_attractor {

struct AttractorParameters {
  double period = 0;
  int modules = 4;
  double phase_sigma = 0.005;
  double height_period = 0;
  double drift_position = 0.06;
  double drift_heading = 0.0012;
  double drift_tail = 4;
  double view_sigma_position = 0;
  double view_sigma_heading = 0.2;
  double prior = 0.05;
  double injection = 1;
  double agreement = 3;
  double inhibition = 0.1;
  double threshold = 0.98;
  double experience_spacing = 5;
  double loop_minimum_travel = -1;
  double loop_spacing = -1;
  bool recalibrate = true;

 private:
  static constexpr auto bumpParameters() {
    using P = AttractorParameters;
    return parameters(
        parameter("period", &P::period)
            .range(0, 1e6)
            .unit("m")
            .doc("Period of the smallest grid module; each further one is 1.42 times larger. 0: 30 "
                 "times experience_spacing."),
        parameter("modules", &P::modules)
            .range(1, 8)
            .doc("Number of grid modules. With one, places one period apart are alike."),
        parameter("phase_sigma", &P::phase_sigma)
            .range(1e-5, 0.2)
            .unit("periods")
            .doc("Standard deviation with which a phase is read, of ring and grid modules."),
        parameter("height_period", &P::height_period)
            .range(0, 1e6)
            .unit("m")
            .doc("Period of the smallest vertical module, so that storeys that look alike are "
                 "different places (20 for buildings); 0: a plane, without height, pitch and "
                 "roll."),
        parameter("drift_position", &P::drift_position)
            .range(0, 100)
            .unit("m/m^0.5")
            .doc("Standard deviation of position that path integration adds to the covariance that "
                 "odometry reports; half of it of height."),
        parameter("drift_heading", &P::drift_heading)
            .range(0, 3)
            .unit("rad/m^0.5")
            .doc("Standard deviation of heading that path integration adds likewise."),
        parameter("drift_tail", &P::drift_tail)
            .range(1, 1e6)
            .doc("Degrees of freedom of the Student's t distribution of drift; large: Gaussian."));
  }

  static constexpr auto energyParameters() {
    using P = AttractorParameters;
    return parameters(
        parameter("view_sigma_position", &P::view_sigma_position)
            .range(0, 1e6)
            .unit("m")
            .doc("Standard deviation, per axis, of the position relative to the template, for "
                 "familiar views without measured pose. 0: 0.6 times experience_spacing."),
        parameter("view_sigma_heading", &P::view_sigma_heading)
            .range(1e-6, 10)
            .unit("rad")
            .doc("Standard deviation of the relative yaw, for familiar views without measured "
                 "pose."),
        parameter("prior", &P::prior)
            .range(1e-6, 0.999)
            .doc("Expected share of right views among familiar ones before any was seen; also the "
                 "probability that the robot is in the mapped area when tracking restarts."),
        parameter("injection", &P::injection)
            .range(0, 100)
            .doc("Factor on the log-likelihood ratio that a view injects; 0: familiar "
                 "views close no loops."),
        parameter("agreement", &P::agreement)
            .range(0, 100)
            .unit("nats")
            .doc("Most energy that a further view adds: log(1/p), where p is the probability that "
                 "the next of several look-alikes in a row agrees with the bump as well."),
        parameter("inhibition", &P::inhibition)
            .range(0, 100)
            .unit("nats")
            .doc("Decay: log odds that each calibration bump loses while experience_spacing is "
                 "driven. It does not depend on other bumps, whose competition is the "
                 "normalisation of shares."),
        parameter("threshold", &P::threshold)
            .range(0, 1)
            .doc("Posterior probability above which a calibration bump is accepted and closes "
                 "loops."));
  }

  static constexpr auto experienceParameters() {
    using P = AttractorParameters;
    return parameters(
        parameter("experience_spacing", &P::experience_spacing)
            .range(1e-3, 1e6)
            .unit("m")
            .doc("Distance between experiences, and between views that count as independent: 5 for "
                 "a car, 0.5 for a camera in a hand. Other lengths follow from it."),
        parameter("loop_minimum_travel", &P::loop_minimum_travel)
            .range(-1, 1e9)
            .unit("m")
            .doc("Views whose template was made less than this travelled distance ago do not "
                 "inject. -1: six times experience_spacing."),
        parameter("loop_spacing", &P::loop_spacing)
            .range(-1, 1e9)
            .unit("m")
            .doc("Shortest travelled distance between two loop links. -1: experience_spacing."),
        parameter("recalibrate", &P::recalibrate)
            .doc("Learn from closed loops the steady errors of odometry (gains of distances and "
                 "turns, turn per second and per metre) and its noise."));
  }

 public:
  static constexpr auto declaration() {
    return std::tuple_cat(bumpParameters(), energyParameters(), experienceParameters());
  }
};

}  // namespace tolman::bayesian_attractor
