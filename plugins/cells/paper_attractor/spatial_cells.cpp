// SPDX-License-Identifier: BSD-3-Clause
#include "spatial_cells.hpp"

#include <algorithm>

namespace tolman::paper_attractor {

void SpatialCells::integrate(const PlanarPose& motion) {
  torus_.move(motion.x, motion.y, ring_.integratedHeading());
  ring_.turn(motion.theta);
}

void SpatialCells::inject(const CellPose& pose, double strength) {
  ring_.inject(Phase<1>(pose.heading), strength);
  torus_.inject(pose.position, strength);
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
  return ring_.disagreement() < settings_.heading && torus_.disagreement() < settings_.position;
}

void SpatialCells::adoptEstimate() {
  ring_.adoptEstimate();
  torus_.adoptEstimate();
}

void SpatialCells::restartCalibrations() {
  ring_.restartCalibration();
  torus_.restartCalibration();
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

}  // namespace tolman::paper_attractor
