// SPDX-License-Identifier: BSD-3-Clause
// One Bayesian attractor network: integrator cells (vestibular cues) and calibration cells (visual
// cues) that inhibit each other and share a constant energy. Axes 1: ring; 2: torus.
#pragma once

#include <algorithm>

#include "periodic_bump.hpp"

namespace tolman::paper_attractor {

/// The defaults are those of the parameters; parameters.hpp has their sources.
struct NetworkSettings {
  double period = 1;                       ///< of every axis: rad on the ring, cells on the torus
  double energy = 1;                       ///< E: the total precision, kept by global inhibition
  double initial_calibration = 0.1;        ///< share of E at the start
  double floor = 1e-4;                     ///< smallest precision of a population
  double inhibition_of_calibration = 0.2;  ///< Delta_cali
  double inhibition_of_integrator = 0.2;   ///< Delta_inte
};

template <int Axes>
class AttractorNetwork {
 public:
  using Bump = PeriodicBump<Axes>;

  explicit AttractorNetwork(const NetworkSettings& settings) : settings_(settings) {
    integrator_.precision = settings.energy;
    calibration_.precision = settings.initial_calibration * settings.energy;
    estimate();
  }

  /// Equation (4): both bumps move along, without deformation.
  void integrate(const Phase<Axes>& displacement) {
    for (Bump* bump : {&integrator_, &calibration_}) {
      const Phase<Axes> moved = bump->mean + displacement;
      bump->mean = wrapped<Axes>(moved, settings_.period);
    }
    injected_.precision = 0;
    estimate();
  }

  /// Equation (5): a familiar view adds `strength` * E to the calibration cells at `mean`.
  void inject(const Phase<Axes>& mean, double strength) {
    injected_ = {mean, strength * settings_.energy};
    calibration_ = combine(calibration_, injected_);
  }

  /// Resets the calibration cells. The integrator cells then have all the energy.
  void restartCalibration() {
    calibration_.precision = settings_.floor;
    integrator_.precision = settings_.energy;
  }

  /// Multiplies the precision of the integrator cells by `factor`, as when odometry is lost.
  void weakenIntegrator(double factor) {
    integrator_.precision = std::max(settings_.floor, factor * integrator_.precision);
  }

  /// Equation (3), both populations from the values before it, then (2), then (6).
  void settle() {
    const double integrator =
        std::max(settings_.floor, integrator_.precision -
                                      settings_.inhibition_of_integrator * calibration_.precision);
    const double calibration =
        std::max(settings_.floor, calibration_.precision -
                                      settings_.inhibition_of_calibration * integrator_.precision);
    const double scale = settings_.energy / (integrator + calibration);
    integrator_.precision = integrator * scale;
    calibration_.precision = calibration * scale;
    estimate();
  }

  /// The paper's step at a familiar place: mu_inte := mu_cc. The calibration cells are reset.
  void adoptEstimate() {
    integrator_.mean = calibration_.mean = estimate_.mean;
    restartCalibration();
    estimate();
  }

  /// |mu_cc - mu_cali|: distance of the estimate from the calibration cells.
  double disagreement() const {
    return distance<Axes>(estimate_.mean, calibration_.mean, settings_.period);
  }
  double calibrationShare() const {
    return calibration_.precision / (integrator_.precision + calibration_.precision);
  }

  const Bump& integrator() const { return integrator_; }
  const Bump& calibration() const { return calibration_; }
  const Bump& estimated() const { return estimate_; }
  const Bump& injected() const { return injected_; }  ///< precision 0: nothing this frame
  double period() const { return settings_.period; }

 private:
  /// Equation (6).
  void estimate() { estimate_ = combine(integrator_, calibration_); }

  Bump combine(const Bump& a, const Bump& b) const {
    return combined<Axes>(a, b, settings_.period);
  }

  NetworkSettings settings_;
  Bump integrator_;
  Bump calibration_;
  Bump injected_;
  Bump estimate_;
};

}  // namespace tolman::paper_attractor
