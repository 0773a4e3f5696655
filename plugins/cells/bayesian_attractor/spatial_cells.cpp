// SPDX-License-Identifier: BSD-3-Clause
#include "spatial_cells.hpp"

#include <algorithm>

namespace tolman::bayesian_attractor {

void SpatialCells::integrate(const PlanarPose& motion) {
  torus_.move(motion.x, motion.y, ring_.integratedHeading());
  ring_.turn(motion.theta);
}

bool SpatialCells::contradictsCalibration(const CellPose& pose) const {
  const double turn = distance<1>(ring_.calibration().mean, Phase<1>(pose.heading), ring_.period());
  const double step = distance<2>(torus_.calibration().mean, pose.position, torus_.period());
  return turn > settings_.gate_heading || step > settings_.gate_position;
}

void SpatialCells::inject(const CellPose& pose, double strength) {
  if (settings_.consistency_gate && contradictsCalibration(pose)) {
    ring_.restartCalibration();
    torus_.restartCalibration();
    support_.views = 0;
  }
  ring_.inject(Phase<1>(pose.heading), strength);
  torus_.inject(pose.position, strength);
  ++support_.views;
  support_.unsupported = 0;
}

void SpatialCells::settle() {
  ring_.settle();
  torus_.settle();
}

void SpatialCells::weakenIntegrators(double factor) {
  ring_.weakenIntegrator(factor);
  torus_.weakenIntegrator(factor);
}

bool SpatialCells::familiar() const {
  return calibrationShare() > settings_.decision_share &&
         ring_.disagreement() < settings_.decision_heading &&
         torus_.disagreement() < settings_.decision_position;
}

void SpatialCells::adoptEstimate() {
  ring_.adoptEstimate();
  torus_.adoptEstimate();
  support_ = {};
}

void SpatialCells::noteUnsupportedView() {
  // With symmetric inhibition a calibration above half wins for good, right or wrong.
  if (++support_.unsupported > settings_.patience) forgetCalibration();
}

void SpatialCells::forgetCalibration() {
  ring_.restartCalibration();
  torus_.restartCalibration();
  support_ = {};
}

CellPose SpatialCells::estimate() const {
  return {ring_.estimated().mean(0), torus_.estimated().mean};
}

CellPose SpatialCells::displaced(const CellPose& pose, const PlanarPose& step) const {
  const Phase<2> position = pose.position + torus_.toCells(step.x, step.y, pose.heading);
  return {wrapPeriod(pose.heading + step.theta, ring_.period()),
          wrapped<2>(position, torus_.period())};
}

double SpatialCells::calibrationShare() const {
  return std::min(ring_.calibrationShare(), torus_.calibrationShare());
}

}  // namespace tolman::bayesian_attractor
